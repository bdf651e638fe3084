#include "svg.h"

#include <cmath>
#include <cstdio>

namespace motorway::tool {

std::string svg_number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    std::string number = text;
    if (number.size() > 2 && number.compare(number.size() - 2, 2, ".0") == 0)
        number.resize(number.size() - 2);
    return number == "-0" ? "0" : number;
}

std::string svg_escaped(const std::string &text)
{
    std::string out;
    for (char c : text) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
        }
    }
    return out;
}

std::string svg_tenths(const std::vector<Point2> &points, bool closed)
{
    std::string path;
    long long x = 0, y = 0;
    for (const Point2 &point : points) {
        const long long next_x = std::llround(10 * point.x), next_y = std::llround(10 * point.y);
        const long long dx = next_x - x, dy = next_y - y;
        path += path.empty() ? "M" : "l";
        path += std::to_string(dx) + (dy < 0 ? "" : " ") + std::to_string(dy);
        x = next_x;
        y = next_y;
    }
    return closed ? path + "z" : path;
}

Svg::Svg(double width, double height, const std::string &title)
{
    head_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + svg_number(width) + " " +
            svg_number(height) + "\" width=\"" + svg_number(width) + "\" height=\"" + svg_number(height) +
            "\" font-family=\"Inter, Helvetica Neue, Helvetica, Arial, sans-serif\">\n<title>" + svg_escaped(title) +
            "</title>\n";
}

std::string Svg::style(const std::string &declarations)
{
    const auto [found, is_new] = classes_.try_emplace(declarations, "c" + std::to_string(classes_.size()));
    if (is_new)
        order_.push_back(&found->first);
    return found->second;
}

void Svg::text(Point2 at, const std::string &declarations, const std::string &words)
{
    add("<text class=\"" + style(declarations) + "\" x=\"" + svg_number(at.x) + "\" y=\"" + svg_number(at.y) + "\">" +
        svg_escaped(words) + "</text>");
}

void Svg::line(Point2 from, Point2 to, const std::string &declarations)
{
    add("<path class=\"" + style(declarations) + "\" d=\"M" + svg_number(from.x) + " " + svg_number(from.y) + "L" +
        svg_number(to.x) + " " + svg_number(to.y) + "\"/>");
}

std::string Svg::finish() const
{
    std::string sheet;
    for (const std::string *declarations : order_)
        sheet += "." + classes_.at(*declarations) + "{" + *declarations + "}\n";
    return head_ + "<style>\n" + sheet + "</style>\n" + body_ + "</svg>\n";
}

} // namespace motorway::tool
