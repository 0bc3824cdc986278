#pragma once
#include <string_view>

namespace gapcheck::report {

/// The beginning of an HTML page of tables, up to the opened body. It loads nothing and runs no scripts.
inline constexpr std::string_view plain_page_head = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<title>gapcheck</title>
<style>
:root { color-scheme: light dark; --error: #c0262d; --warning: #9a5b00; --note: #2a6f97; --clean: #1f7a3d; }
@media (prefers-color-scheme: dark) {
  :root { --error: #ff7b80; --warning: #f0b455; --note: #7cc4ea; --clean: #6fd391; }
}
body { margin: 12px; font: 13px/1.45 system-ui, sans-serif; }
h1 { font-size: 15px; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: 3px 8px; border-bottom: 1px solid #8886; overflow-wrap: anywhere; }
td.number, th.number { text-align: right; white-space: nowrap; }
.error, .unread { color: var(--error); } .warning { color: var(--warning); } .note { color: var(--note); }
.clean { color: var(--clean); }
</style>
</head>
<body>
)";

}  // namespace gapcheck::report
