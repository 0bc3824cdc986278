"""A report in a notebook."""
from html import escape

SHOWN = 20  # contacts, findings


def _table(heads, rows):
    head = "".join(f"<th>{escape(each)}</th>" for each in heads)
    body = "".join("<tr>" + "".join(f"<td>{escape(str(each))}</td>" for each in row) + "</tr>" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _more(count):
    return f"<p>{count - SHOWN} more</p>" if count > SHOWN else ""


def summary(report, page=None):
    """Counts and a table of contacts as HTML. page: of a browser, shown in a frame that reaches nothing outside."""
    totals, contacts, findings = report.totals, report.contacts, report.findings
    text = (f"<p><b>{escape(report.input)}</b>: {totals.errors} errors, {totals.warnings} warnings, {totals.notes} notes"
            f"{'' if report.complete else '; not read in full'}</p>")
    text += _table(("contact", "title", "keyword", "penetrations", "deepest", "released", "untied", "not judged"),
                   [(each.id, each.title, each.keyword, each.penetrations, f"{each.max_penetration:g}", each.released,
                     each.untied, each.not_checked) for each in contacts[:SHOWN]]) + _more(len(contacts))
    if findings:
        text += _table(("rule", "severity", "finding"),
                       [(f"{each.id} {each.rule}", each.severity, each.message) for each in findings[:SHOWN]])
        text += _more(len(findings))
    if page is not None:
        text += f'<iframe sandbox="allow-scripts" style="width: 100%; height: 600px" srcdoc="{escape(page)}"></iframe>'
    return f"<div>{text}</div>"
