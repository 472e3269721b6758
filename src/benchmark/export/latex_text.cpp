#include "src/benchmark/export/latex_text.h"

#include "src/core/one_line.h"

namespace ricochet::exports {

std::string latex_text(std::string_view text) {
  std::string tex;
  for (const char c : one_line(text)) {
    switch (c) {
      case '\\':
        tex += "\\textbackslash{}";
        break;
      case '~':
        tex += "\\textasciitilde{}";
        break;
      case '^':
        tex += "\\textasciicircum{}";
        break;
      case '<':
        tex += "\\textless{}";
        break;
      case '>':
        tex += "\\textgreater{}";
        break;
      case '|':
        tex += "\\textbar{}";
        break;
      case '"':
        tex += "\\textquotedbl{}";
        break;
      case '\'':
        tex += "\\textquotesingle{}";
        break;
      case '`':
        tex += "\\textasciigrave{}";
        break;
      case '-':  // LaTeX would turn two of them into a dash
        tex += tex.ends_with('-') ? "{}-" : "-";
        break;
      case '[':  // after the end of a row LaTeX would read these as part of it
      case '*':
        tex += {'{', c, '}'};
        break;
      case '#':
      case '$':
      case '%':
      case '&':
      case '_':
      case '{':
      case '}':
        tex += '\\';
        [[fallthrough]];
      default:
        tex += c;
    }
  }
  return tex;
}

}  // namespace ricochet::exports
