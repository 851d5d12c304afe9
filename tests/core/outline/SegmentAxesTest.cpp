// SPDX-License-Identifier: Apache-2.0
#include "core/outline/SegmentAxes.h"

#include "core/measure/MeasuredSize.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

namespace segmentAxesTest {

using namespace core;

namespace {

/// Pixels of 0.5 × 0.8 mm in a plane that is turned about z; sheared if asked.
SliceLattice latticeOf(const glm::ivec2& size, double shear = 0.0)
{
    SliceLattice lattice;
    lattice.size = size;
    const glm::dvec3 right = glm::normalize(glm::dvec3(3, 1, 0));
    const glm::dvec3 down = glm::normalize(glm::dvec3(-1, 3, 0));
    lattice.originLps = {7, -3, 11};
    lattice.columnLps = 0.5 * right;
    lattice.rowLps = 0.8 * down + shear * right;
    return lattice;
}

glm::dvec3 placeOf(const SliceLattice& lattice, double x, double y)
{
    return lattice.originLps + x * lattice.columnLps + y * lattice.rowLps;
}

template <class Inside>
std::vector<std::uint8_t> pixelsOf(const SliceLattice& lattice, const Inside& isInside)
{
    std::vector<std::uint8_t> inside;
    for (int y = 0; y < lattice.size.y; ++y) {
        for (int x = 0; x < lattice.size.x; ++x)
            inside.push_back(isInside(x, y) ? 1 : 0);
    }
    return inside;
}

std::optional<SegmentAxes> evenAxes(
    const SliceLattice& lattice, const std::vector<std::uint8_t>& inside, const glm::ivec2& pixel)
{
    return segmentAxes(lattice, VolumeGeometry(), inside, pixel);
}

/// The longest chord across a direction through one of the places, of those between any two
/// segments that join places, mm across.
double widestOf(
    const std::vector<glm::dvec3>& places, const glm::dvec3& along, const glm::dvec3& across)
{
    double widest = 0.0;
    for (const glm::dvec3& corner : places) {
        const double place = glm::dot(corner, along);
        double low = glm::dot(corner, across);
        double high = low;
        for (const glm::dvec3& a : places) {
            if (std::abs(glm::dot(a, along) - place) < 1e-9) {
                low = std::min(low, glm::dot(a, across));
                high = std::max(high, glm::dot(a, across));
            }
            for (const glm::dvec3& b : places) {
                const double from = glm::dot(a, along) - place;
                const double to = glm::dot(b, along) - place;
                if (!(from < 0.0 && to > 0.0))
                    continue;
                const glm::dvec3 met = a + (b - a) * (from / (from - to));
                low = std::min(low, glm::dot(met, across));
                high = std::max(high, glm::dot(met, across));
            }
        }
        widest = std::max(widest, high - low);
    }
    return widest;
}

/// Slices of 0.6 mm, and above them some that are far apart.
Volume unevenVolume()
{
    Volume volume;
    VolumeGeometry& geometry = volume.geometry;
    geometry.size = {16, 14, 12};
    double z = 30.0;
    for (int k = 0; k < geometry.size.z; ++k) {
        geometry.slicePositions.emplace_back(-5.0, 2.0, z);
        z += k < 6 ? 0.6 : 4.5;
    }
    const glm::dvec3 step = (geometry.slicePositions.back() - geometry.slicePositions.front())
        / double(geometry.size.z - 1);
    geometry.indexToWorld =
        glm::dmat4(glm::dvec4(0.8, 0.0, 0.0, 0.0), glm::dvec4(0.0, 0.9, 0.0, 0.0),
            glm::dvec4(step, 0.0), glm::dvec4(geometry.slicePositions.front(), 1.0));
    return volume;
}

/// The true places of the sides' midpoints of those pixels that are no inner ones.
std::vector<glm::dvec3> trueBorder(const SliceLattice& lattice, const VolumeGeometry& geometry,
    const std::vector<std::uint8_t>& inside)
{
    const auto isInside = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < lattice.size.x && y < lattice.size.y
            && inside[std::size_t(y * lattice.size.x + x)] != 0;
    };
    std::vector<glm::dvec3> places;
    for (int y = 0; y < lattice.size.y; ++y) {
        for (int x = 0; x < lattice.size.x; ++x) {
            const bool isInner = isInside(x - 1, y) && isInside(x + 1, y) && isInside(x, y - 1)
                && isInside(x, y + 1);
            if (!isInside(x, y) || isInner)
                continue;
            for (const glm::dvec2& side :
                {glm::dvec2(0.5, 0), glm::dvec2(-0.5, 0), glm::dvec2(0, 0.5), glm::dvec2(0, -0.5)})
                places.push_back(truePlace(geometry, placeOf(lattice, x + side.x, y + side.y)));
        }
    }
    return places;
}

double longOf(const SegmentAxes& axes)
{
    return glm::distance(axes.longFromLps, axes.longToLps);
}

double shortOf(const SegmentAxes& axes)
{
    return glm::distance(axes.shortFromLps, axes.shortToLps);
}

double betweenThem(const SegmentAxes& axes)
{
    return std::abs(
               glm::dot(axes.longToLps - axes.longFromLps, axes.shortToLps - axes.shortFromLps))
        / (longOf(axes) * shortOf(axes));
}

} // namespace

class SegmentAxesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// 12 × 1 pixels: from side to side along the row, and across it in the middle of each.
    void aRowOfPixels()
    {
        const SliceLattice lattice = latticeOf({20, 9});
        const auto inside =
            pixelsOf(lattice, [](int x, int y) { return y == 4 && x >= 3 && x <= 14; });
        const auto axes = evenAxes(lattice, inside, {7, 4});
        QVERIFY(axes);
        QVERIFY(std::abs(longOf(*axes) - 12 * 0.5) < 1e-9);
        QVERIFY(std::abs(shortOf(*axes) - 0.8) < 1e-9);
        QVERIFY(betweenThem(*axes) < 1e-9);
        QVERIFY(glm::distance(axes->longFromLps, placeOf(lattice, 2.5, 4)) < 1e-9
            || glm::distance(axes->longToLps, placeOf(lattice, 2.5, 4)) < 1e-9);
    }

    /// An ellipse of any direction has its axes, to within a pixel.
    void anEllipse_data()
    {
        QTest::addColumn<double>("degrees");
        QTest::addColumn<double>("shear");
        for (const double degrees : {0.0, 20.0, 65.0, 90.0, 130.0}) {
            QTest::addRow("%g", degrees) << degrees << 0.0;
            QTest::addRow("%g, sheared", degrees) << degrees << 0.2;
        }
    }
    void anEllipse()
    {
        QFETCH(const double, degrees);
        QFETCH(const double, shear);
        const SliceLattice lattice = latticeOf({160, 110}, shear);
        const glm::dvec3 middle = placeOf(lattice, 80, 55);
        const glm::dvec3 right = glm::normalize(glm::dvec3(3, 1, 0));
        const glm::dvec3 down = glm::normalize(glm::dvec3(-1, 3, 0));
        const double turn = glm::radians(degrees);
        const glm::dvec3 along = std::cos(turn) * right + std::sin(turn) * down;
        const glm::dvec3 across = -std::sin(turn) * right + std::cos(turn) * down;
        const auto inside = pixelsOf(lattice, [&](int x, int y) {
            const glm::dvec3 way = placeOf(lattice, x, y) - middle;
            const double a = glm::dot(way, along) / 24.0;
            const double b = glm::dot(way, across) / 13.0;
            return a * a + b * b <= 1.0;
        });
        const auto axes = evenAxes(lattice, inside, {80, 55});
        QVERIFY(axes);
        QVERIFY2(std::abs(longOf(*axes) - 48.0) < 0.9, qPrintable(QString::number(longOf(*axes))));
        QVERIFY2(
            std::abs(shortOf(*axes) - 26.0) < 0.9, qPrintable(QString::number(shortOf(*axes))));
        QVERIFY(betweenThem(*axes) < 1e-9);
        const glm::dvec3 found = glm::normalize(axes->longToLps - axes->longFromLps);
        QVERIFY(std::abs(glm::dot(found, along)) > std::cos(glm::radians(6.0)));
    }

    /// The longest distance of any two places, and of chords across it, by trying all.
    void noOtherIsLonger()
    {
        test::Random random(5);
        for (int round = 0; round < 30; ++round) {
            const SliceLattice lattice = latticeOf({13, 11}, round % 2 == 0 ? 0.0 : 0.3);
            std::vector<std::uint8_t> inside(13 * 11, 0);
            glm::ivec2 at(6, 5);
            for (int step = 0; step < 40; ++step) {
                inside[std::size_t(at.y * 13 + at.x)] = 1;
                at = glm::clamp(
                    at + glm::ivec2(test::randomInt(random, -1, 1), test::randomInt(random, -1, 1)),
                    glm::ivec2(0), glm::ivec2(12, 10));
            }
            const auto axes = evenAxes(lattice, inside, {6, 5});
            QVERIFY(axes);
            std::vector<glm::dvec3> places;
            for (int y = 0; y < 11; ++y) {
                for (int x = 0; x < 13; ++x) {
                    if (inside[std::size_t(y * 13 + x)] == 0)
                        continue;
                    for (const glm::dvec2& side : {glm::dvec2(0.5, 0), glm::dvec2(-0.5, 0),
                             glm::dvec2(0, 0.5), glm::dvec2(0, -0.5)})
                        places.push_back(placeOf(lattice, x + side.x, y + side.y));
                }
            }
            double longest = 0.0;
            for (const glm::dvec3& a : places) {
                for (const glm::dvec3& b : places)
                    longest = std::max(longest, glm::distance(a, b));
            }
            QVERIFY(std::abs(longOf(*axes) - longest) < 1e-9);
            // Chords of the hull: between any two segments that join places.
            const glm::dvec3 along = glm::normalize(axes->longToLps - axes->longFromLps);
            const glm::dvec3 across = glm::cross(glm::dvec3(0, 0, 1), along);
            const double widest = widestOf(places, along, across);
            QVERIFY2(std::abs(shortOf(*axes) - widest) < 1e-6,
                qPrintable(QStringLiteral("%1 %2").arg(shortOf(*axes)).arg(widest)));
        }
    }

    /// Of slices across unevenly spaced ones: what is measured between both ends of the long axis
    /// is the longest distance that there truly is, and the short one is truly across it.
    void betweenUnevenSlices_data()
    {
        QTest::addColumn<double>("rightX");
        QTest::addColumn<double>("downY");
        QTest::addColumn<double>("lean");
        QTest::addRow("sagittal") << 0.0 << 0.0 << 0.0;
        QTest::addRow("coronal") << 1.0 << 0.0 << 0.0;
        QTest::addRow("axial") << 1.0 << 1.0 << 0.0;
        QTest::addRow("oblique") << 1.0 << 0.7 << 0.0;
        QTest::addRow("oblique, another blob") << 1.0 << 0.4 << 0.9;
        QTest::addRow("sagittal, another blob") << 0.0 << 0.0 << -0.9;
    }
    void betweenUnevenSlices()
    {
        QFETCH(const double, rightX);
        QFETCH(const double, downY);
        QFETCH(const double, lean);
        const Volume volume = unevenVolume();
        const VolumeGeometry& geometry = volume.geometry;
        const glm::dvec3 through = geometry.toWorld({8.0, 7.0, 6.0});
        const glm::dvec3 right(rightX, 1.0 - rightX, 0.0);
        const glm::dvec3 down(0.0, downY, -std::sqrt(1.0 - downY * downY));
        const SliceLattice lattice = sliceLattice(geometry, through, right, down);
        QVERIFY(!lattice.empty());
        std::vector<std::uint8_t> inside;
        for (const glm::ivec3& voxel : nearestVoxels(lattice, geometry)) {
            const glm::dvec3 off =
                (glm::dvec3(voxel) - glm::dvec3(8.0, 7.0, 6.0)) / glm::dvec3(5.5, 4.5, 4.5);
            inside.push_back(glm::dot(off, off) + lean * (off.x + off.y) * off.z <= 1.0 ? 1 : 0);
        }
        const auto pixel = lattice.pixelAt(through);
        QVERIFY(pixel);
        const auto axes = segmentAxes(lattice, geometry, inside, *pixel);
        QVERIFY(axes);
        const std::vector<glm::dvec3> places = trueBorder(lattice, geometry, inside);
        double longest = 0.0;
        for (const glm::dvec3& a : places) {
            for (const glm::dvec3& b : places)
                longest = std::max(longest, glm::distance(a, b));
        }
        const auto measured = [&volume](const glm::dvec3& from, const glm::dvec3& to) {
            return *measuredSize(Measurement{.pointsLps = {from, to}}, volume).length;
        };
        const double longMm = measured(axes->longFromLps, axes->longToLps);
        const double shortMm = measured(axes->shortFromLps, axes->shortToLps);
        QVERIFY2(std::abs(longMm - longest) < 1e-6,
            qPrintable(QStringLiteral("%1, %2").arg(longMm).arg(longest)));
        QVERIFY(shortMm > 0.0 && shortMm <= longMm + 1e-6);
        const glm::dvec3 along = glm::normalize(
            truePlace(geometry, axes->longToLps) - truePlace(geometry, axes->longFromLps));
        const glm::dvec3 way =
            truePlace(geometry, axes->shortToLps) - truePlace(geometry, axes->shortFromLps);
        QVERIFY(std::abs(glm::dot(way, along)) < 1e-6 * shortMm);
        const glm::dvec3 across = glm::normalize(glm::cross(glm::cross(right, down), along));
        const double widest = widestOf(places, along, across);
        QVERIFY2(std::abs(std::abs(glm::dot(way, across)) - widest) < 1e-6,
            qPrintable(QStringLiteral("%1, %2").arg(glm::dot(way, across)).arg(widest)));
        // The slice shows all four ends.
        for (const glm::dvec3& end :
            {axes->longFromLps, axes->longToLps, axes->shortFromLps, axes->shortToLps})
            QVERIFY(std::abs(glm::dot(end - through, glm::cross(right, down))) < 1e-6);
    }

    void onlyWhatHangsTogetherCounts()
    {
        const SliceLattice lattice = latticeOf({30, 10});
        // Two blocks; one pixel more touches the first at a corner.
        const auto inside = pixelsOf(lattice, [](int x, int y) {
            return (y == 2 && x >= 1 && x <= 4) || (x == 5 && y == 3) || (y == 2 && x >= 20);
        });
        const auto left = evenAxes(lattice, inside, {2, 2});
        const auto right = evenAxes(lattice, inside, {25, 2});
        QVERIFY(left && right);
        QVERIFY(std::abs(longOf(*right) - 5.0) < 1e-9);
        QVERIFY(longOf(*left) > 2.5 && longOf(*left) < 2.8);
        QVERIFY(!evenAxes(lattice, inside, {10, 2}));
        QVERIFY(!evenAxes(lattice, inside, {-1, 2}));
        QVERIFY(!evenAxes(lattice, inside, {30, 2}));
        QVERIFY(!evenAxes(SliceLattice(), {}, {0, 0}));
    }
};

BURIN_TEST(SegmentAxesTest)

} // namespace segmentAxesTest

#include "SegmentAxesTest.moc"
