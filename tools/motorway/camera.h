/* Space onto paper: a perspective camera with y up, and the few operations on vectors that it needs. */
#ifndef MOTORWAY_TOOL_CAMERA_H
#define MOTORWAY_TOOL_CAMERA_H

#include <cmath>
#include <vector>

namespace motorway::tool {

struct Vec3 {
    double x, y, z;
};

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double k, Vec3 a) { return {k * a.x, k * a.y, k * a.z}; }
inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline Vec3 unit(Vec3 a) { return length(a) > 0 ? (1 / length(a)) * a : Vec3{0, 0, 1}; }

/* The vector i of an array x y z x y z ... */
inline Vec3 vector_at(const std::vector<double> &xyz, std::size_t i)
{
    return {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
}

struct Point2 {
    double x, y; /* y grows downwards, as on paper */
};

struct Rectangle {
    double left, top, right, bottom;
};

class Camera {
public:
    /* Looks at all of `content` from the direction with this azimuth about the y axis (0: from +z) and elevation, in
     * degrees, and scales what it sees so that it just fits the frame. */
    Camera(const std::vector<Vec3> &content, double azimuth, double elevation, const Rectangle &frame);

    Point2 project(Vec3 point) const;
    double distance(Vec3 point) const { return length(point - eye_); }
    Vec3 towards_eye(Vec3 point) const { return unit(eye_ - point); }
    Vec3 right() const { return right_; }
    Vec3 up() const { return up_; }

    /* The size on paper of a unit length at this point. */
    double scale_at(Vec3 point) const { return scale_ / dot(eye_ - point, back_); }

private:
    Vec3 eye_, right_, up_, back_;
    double scale_ = 1;
    Point2 shift_ = {0, 0};
};

} // namespace motorway::tool

#endif
