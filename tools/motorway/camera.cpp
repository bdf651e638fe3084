#include "camera.h"

#include <algorithm>

namespace motorway::tool {

Camera::Camera(const std::vector<Vec3> &content, double azimuth, double elevation, const Rectangle &frame)
{
    constexpr double DEGREE = 3.14159265358979323846 / 180;
    constexpr double FAR = 3.6; /* radii of the content from its middle: a mild perspective */
    Vec3 low = content.front(), high = content.front();
    for (Vec3 p : content) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vec3 middle = 0.5 * (low + high);
    const double radius = std::max(0.5 * length(high - low), 1e-30);
    const double a = azimuth * DEGREE, e = elevation * DEGREE;
    back_ = {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
    right_ = unit(cross({0, 1, 0}, back_));
    up_ = cross(back_, right_);
    eye_ = middle + FAR * radius * back_;

    Rectangle seen = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (Vec3 p : content) {
        const Point2 q = project(p);
        seen = {std::min(seen.left, q.x), std::min(seen.top, q.y), std::max(seen.right, q.x),
                std::max(seen.bottom, q.y)};
    }
    const double width = std::max(seen.right - seen.left, 1e-30), height = std::max(seen.bottom - seen.top, 1e-30);
    scale_ = std::min((frame.right - frame.left) / width, (frame.bottom - frame.top) / height);
    shift_ = {0.5 * (frame.left + frame.right) - scale_ * 0.5 * (seen.left + seen.right),
              0.5 * (frame.top + frame.bottom) - scale_ * 0.5 * (seen.top + seen.bottom)};
}

Point2 Camera::project(Vec3 point) const
{
    const Vec3 ray = point - eye_;
    const double depth = -dot(ray, back_);
    return {shift_.x + scale_ * dot(ray, right_) / depth, shift_.y - scale_ * dot(ray, up_) / depth};
}

} // namespace motorway::tool
