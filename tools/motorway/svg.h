/* The text of an SVG file: elements one after the other, with styles that are named once and shared. */
#ifndef MOTORWAY_TOOL_SVG_H
#define MOTORWAY_TOOL_SVG_H

#include <map>
#include <string>
#include <vector>

#include "camera.h"

namespace motorway::tool {

/* A number with at most one decimal. */
std::string svg_number(double value);

/* The text with & < > and quotes written so that XML takes them. */
std::string svg_escaped(const std::string &text);

/* Path data: a polyline through the points in whole numbers of tenths, each relative to the last, closed or not. */
std::string svg_tenths(const std::vector<Point2> &points, bool closed);

class Svg {
public:
    Svg(double width, double height, const std::string &title);

    /* The name of a class with these CSS declarations. */
    std::string style(const std::string &declarations);

    void add(const std::string &element) { body_ += element + "\n"; }
    void text(Point2 at, const std::string &declarations, const std::string &words);
    void line(Point2 from, Point2 to, const std::string &declarations);

    std::string finish() const;

private:
    std::string head_, body_;
    std::map<std::string, std::string> classes_;
    std::vector<const std::string *> order_;
};

} // namespace motorway::tool

#endif
