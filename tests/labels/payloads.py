# SPDX-License-Identifier: BSD-3-Clause
"""Labels that mean something to a sink: each tries to run a command, to load a file, or to break what it stands in.

Commands that are run leave a file called CANARY in the folder where the programs run."""

CANARY = "canary"

ORDINARY = [
    "[1]", "*", "*a*", "**b**", "a|b", "||", "`code`", "``", "$x^2$", "\\alpha", "\\", "a\\|b", "~~s~~", "_u_", "__u__",
    "{x}", "x^{2}_i", "'quoted'", "it's", "'", "''", "a''b", "\"double\"", "\"", "# h", "1. item", "> q", "![i](u)",
    "[t](u)", "http://a.b/c", "a@b.c", "a,b", "a;b", "a  b", "%d %s", "50%", "a#b", "!x", "?", "...", "(c)",
    "ä ö ü ß", "ŁÓDŹ", "Ω ≤ λ", "€ “q” — –", "中文", "😀", "a -- b", "/usr/bin", "null", "NaN", "1e3", "007"]

HTML = [
    "<b>bold</b>", "<script>alert(1)</script>", "a -->", "<!-- b", "&amp;", "&lt;x&gt;", "x&y", "</script>",
    "</script><script>alert(2)</script>", "<img src=x onerror=alert(1)>", "<svg onload=alert(1)>", "</td></tr></table>",
    "<a href=\"javascript:alert(1)\">x</a>", "javascript:alert(1)", "\" onmouseover=\"alert(1)",
    "' autofocus onfocus='x",
    "<iframe src=//a.b>", "<style>*{display:none}</style>", "<base href=//a.b/>", "<template>", "<textarea>",
    "<plaintext>",
    "&#60;script&#62;", "&#x3c;b&#x3e;", "&lt", "&;", "<", ">", "<>", "</", "<!DOCTYPE html>", "<![x]-->", "{{7*7}}",
    "${7*7}", "<%= 7 %>", "#{7}", "__proto__", "constructor", "toString"]

SVG = ["]]>", "<![CDATA[x]]>", "<!ENTITY x \"y\">", "&xxe;", "<?xml version=\"1.0\"?>", "<?php phpinfo(); ?>",
       "<text>x</text>", "</svg>", "</g></svg>", "<use xlink:href=\"#x\"/>", "<foreignObject>x</foreignObject>",
       "&nbsp;"]

LATEX = [
    "\\input{x}", "\\input{/etc/passwd}", "\\input|\"touch canary\"", "\\write18{touch canary}",
    "\\immediate\\write18{touch canary}", "\\openout1=canary", "\\newwrite\\f", "^^5cinput{x}", "\\end{tabular}",
    "\\end{document}", "\\def\\a{\\a}\\a", "\\csname x\\endcsname", "\\catcode`\\$=12", "a & b \\\\", "\\hline",
    "a % b",
    "$$", "$\\infty", "}", "{", "}}{{", "\\verb|x|", "\\n", "~", "^", "_", "a~b", "\\\\[1cm]", "\\char92", "a---b",
    "``x''", "?`", "!`", "<<x>>", ",,x", "<<", ">>", "x,,"]

GNUPLOT = ["'; print 1; '", "`touch canary`", "\"; system \"touch canary\"; \"", "'; system('touch canary'); '",
           "a@canary", "a@@", "a@{a}^b", "{/Symbol a}", "{/*9 x}", "&{x}", "a\\nb", "\\\"", "\\'", "\\101", "%g", "%%",
           "!touch canary", "a\" noenhanced", "', 'x' with lines", "a^b_c", "~a{.6b}", "\\U+2603", "x{", "a\\", "$DATA"]

SHELL = ["$(id)", "$(touch canary)", "; touch canary", "| touch canary", "&& touch canary", "> canary", "$IFS",
         "${HOME}",
         "a$(touch canary)b", "'$(touch canary)'", "\"$(touch canary)\"", "\\$(touch canary)", "!!", "~root", "*.csv",
         "{a,b}", "a&", "<(touch canary)", "$'touch canary'", "`id`"]

CSV = ["x\",=1+1,\"", "\",\"", "a\",\"b", "\"\"", ",=1+1", ";=1+1", "x=cmd|'/C calc'!A0", "'=1+1",
       "(=1+1)", "\"=1+1\"", "%0A=1+1", "a,b,c,d", "\",,,", "1+1", "|=1+1"]

MARKDOWN = ["|---|", "a | b", "\\|", "<br>", "[x]: u", "[^1]", "***", "* [ ] x", "<http://a.b>", ":-)", ":smile:",
            "$`x`$", "~~~", "```", "\\`x\\`", "&vert;", "* * *", "1) x", "www.a.b", "[[x]]", "a ==x==", "^x^",
            "!!! note"]

HOSTILE = HTML + SVG + LATEX + GNUPLOT + SHELL + CSV + MARKDOWN
ALL = ORDINARY + HOSTILE
