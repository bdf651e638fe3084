#include "colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace motorway::tool {

static double gamma_encoded(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/* Björn Ottosson's OKLab to linear sRGB. */
static std::array<double, 3> linear_rgb(const Colour &colour)
{
    const double angle = colour.hue * 3.14159265358979323846 / 180;
    const double a = colour.chroma * std::cos(angle), b = colour.chroma * std::sin(angle);
    const double l = std::pow(colour.lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(colour.lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(colour.lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

std::string hex(const Colour &colour)
{
    Colour shown = colour;
    std::array<double, 3> rgb = linear_rgb(shown);
    const auto is_shown = [](double c) { return c > -1e-3 && c < 1 + 1e-3; };
    const auto fits = [&] { return std::all_of(rgb.begin(), rgb.end(), is_shown); };
    for (int step = 0; step < 40 && !fits(); ++step) {
        shown.chroma *= 0.95;
        rgb = linear_rgb(shown);
    }
    int byte[3];
    for (int k = 0; k < 3; ++k)
        byte[k] = static_cast<int>(std::lround(255 * gamma_encoded(std::clamp(rgb[k], 0.0, 1.0))));
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", byte[0] & 0xff, byte[1] & 0xff, byte[2] & 0xff);
    return text;
}

Colour gradient(double share)
{
    const double t = std::clamp(share, 0.0, 1.0);
    return {0.60 + 0.20 * t, 0.155 - 0.01 * t, 262 + t * (430 - 262)};
}

} // namespace motorway::tool
