// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace core {

/// Something that is measured or noted at places in the patient. The points are the true ones, even
/// if they are shown elsewhere, on a piece that was moved or zoomed. Results are not stored:
/// core/measure computes sizes from the points and statistics from the voxels.
struct Measurement {
    /// The kind decides what the points mean.
    enum class Kind {
        Distance, ///< both ends
        Angle, ///< one end, the vertex, the other end
        Ellipse, ///< the centre and the ends of two half axes
        Rectangle, ///< a corner and the two beside it
        Outline, ///< corners in one plane, closed from the last to the first
        Ball, ///< the centre and a point of its surface
        Probe, ///< the place
        Arrow, ///< the tip and the other end
        Text, ///< the place
    };

    int id = 0; ///< 1, 2, 3 …, unique and never used again
    Kind kind = Kind::Distance;
    std::vector<glm::dvec3> pointsLps{};
    /// The piece on which all points were picked, and with which they move in 3D; 0: none.
    int piece = 0;
    QString text{}; ///< what an arrow or a text says
    /// Whether it was drawn over a picture without depth (a thick slab, a projection of the
    /// volume). Its length is then that of its projection.
    bool projected = false;

    /// The length of a distance between its points as stored; for uneven slices see
    /// core/measure/MeasuredSize.h.
    [[nodiscard]] double lengthMm() const { return glm::distance(pointsLps[0], pointsLps[1]); }
    /// Whether it encloses a region of a plane.
    [[nodiscard]] bool isPlaneRegion() const
    {
        return kind == Kind::Ellipse || kind == Kind::Rectangle || kind == Kind::Outline;
    }
    /// Whether it encloses voxels.
    [[nodiscard]] bool isRegion() const { return isPlaneRegion() || kind == Kind::Ball; }
    bool operator==(const Measurement&) const = default;
};

/// The number of points of a kind; an outline may have more.
[[nodiscard]] constexpr std::size_t pointsOf(Measurement::Kind kind)
{
    switch (kind) {
    case Measurement::Kind::Probe:
    case Measurement::Kind::Text:
        return 1;
    case Measurement::Kind::Distance:
    case Measurement::Kind::Ball:
    case Measurement::Kind::Arrow:
        return 2;
    case Measurement::Kind::Angle:
    case Measurement::Kind::Ellipse:
    case Measurement::Kind::Rectangle:
    case Measurement::Kind::Outline:
        break;
    }
    return 3;
}

/// The kinds, in their order, as edits and hashed states name them.
inline constexpr std::array<const char*, 9> measurementWords{
    "distance", "angle", "ellipse", "rectangle", "outline", "ball", "probe", "arrow", "text"};

} // namespace core
