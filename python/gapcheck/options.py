"""Options that several functions take."""
import datetime


def common(includes, skip_missing, parameters, jobs):
    """Those of everything that reads decks."""
    if isinstance(parameters, dict):
        parameters = [f"{name}={value}" for name, value in parameters.items()]
    return {"includes": includes, "skip_missing": skip_missing, "parameters": parameters, "jobs": jobs}


def days(today):
    """Days from 1970-01-01 to a date; None: the local day."""
    if today is None:
        today = datetime.date.today()
    if not isinstance(today, datetime.date):
        raise TypeError(f"today: a datetime.date is needed, not {type(today).__name__}")
    return max(0, today.toordinal() - datetime.date(1970, 1, 1).toordinal())
