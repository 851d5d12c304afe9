// SPDX-License-Identifier: Apache-2.0
#include "core/measure/MeasuredSize.h"

#include "core/measure/PlaneShape.h"
#include "tests/support/cases/MeasurePhantoms.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <cmath>

namespace measuredSizeTest {

using namespace core;
using Kind = Measurement::Kind;

namespace {

/// As an edit rounds it.
glm::dvec3 onGrid(const glm::dvec3& place)
{
    return glm::round(place * 1024.0) / 1024.0;
}

/// Measured where a view shows these places of the patient.
MeasuredSize sizeOf(
    const test::MeasurePhantom& phantom, Kind kind, const std::vector<glm::dvec3>& trueLps)
{
    Measurement measured{.id = 1, .kind = kind};
    for (const glm::dvec3& place : trueLps)
        measured.pointsLps.push_back(onGrid(phantom.shown(place)));
    return measuredSize(measured, phantom.volume);
}

/// Within 0.1 %.
bool agrees(const std::optional<double>& measured, double known)
{
    const bool fine = measured && std::abs(*measured - known) <= 0.001 * known;
    if (!fine)
        qWarning("%g instead of %g", measured.value_or(-1.0), known);
    return fine;
}

/// Two directions in an oblique plane, perpendicular.
const glm::dvec3 along = glm::normalize(glm::dvec3(2, 1, 1));
const glm::dvec3 across = glm::normalize(glm::cross(along, glm::dvec3(0, 1, -3)));

Volume withProblem(ProblemCode code)
{
    Volume volume;
    volume.geometry.size = {10, 10, 10};
    volume.geometry.indexToWorld =
        glm::dmat4({0.5, 0, 0, 0}, {0, 0.5, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1});
    volume.problems.push_back(
        {.kind = VolumeProblem::Kind::AssumedSpacing, .said = {code}, .caution = true});
    return volume;
}

} // namespace

class MeasuredSizeTest : public QObject {
    Q_OBJECT

private:
    static void everyPhantom()
    {
        QTest::addColumn<int>("index");
        const std::vector<test::MeasurePhantom> phantoms = test::measurePhantoms();
        for (std::size_t i = 0; i < phantoms.size(); ++i)
            QTest::newRow(phantoms[i].name) << int(i);
    }
    static test::MeasurePhantom phantom(int index)
    {
        return test::measurePhantoms()[std::size_t(index)];
    }

private Q_SLOTS:
    void lengthsAndAngles_data() { everyPhantom(); }
    void lengthsAndAngles()
    {
        QFETCH(const int, index);
        const test::MeasurePhantom study = phantom(index);
        // Along each axis and across all of them; never only in one slice.
        for (const glm::dvec3& way : {glm::dvec3(31, 0, 0), glm::dvec3(0, 17, 0),
                 glm::dvec3(0, 0, 29), glm::dvec3(12, -9, 20), glm::dvec3(0.5, 0.25, 3.0)}) {
            const glm::dvec3 from(-3.0, 2.0, -12.0);
            const MeasuredSize size = sizeOf(study, Kind::Distance, {from, from + way});
            QVERIFY(agrees(size.length, glm::length(way)));
            QVERIFY(!size.inVoxels && !size.area && !size.angleDegrees);
        }
        for (const double degrees : {5.0, 30.0, 90.0, 135.0, 178.0}) {
            const double turn = glm::radians(degrees);
            const glm::dvec3 vertex(1.0, -2.0, -4.0);
            const MeasuredSize size = sizeOf(study, Kind::Angle,
                {vertex + 25.0 * along, vertex,
                    vertex + 19.0 * (std::cos(turn) * along + std::sin(turn) * across)});
            QVERIFY(agrees(size.angleDegrees, degrees));
            QVERIFY(!size.length);
        }
    }

    void ballsHaveTheirVolume_data() { everyPhantom(); }
    void ballsHaveTheirVolume()
    {
        QFETCH(const int, index);
        for (const glm::dvec3& way : {glm::dvec3(8, 0, 0), glm::dvec3(0, 0, 21), 14.0 * across}) {
            const glm::dvec3 centre(2.0, 3.0, -5.0);
            const MeasuredSize size = sizeOf(phantom(index), Kind::Ball, {centre, centre + way});
            const double radius = glm::length(way);
            QVERIFY(agrees(size.volume, 4.0 / 3.0 * M_PI * radius * radius * radius));
            QVERIFY(agrees(size.longAxis, 2.0 * radius));
        }
    }

    void regionsHaveTheirArea_data() { everyPhantom(); }
    void regionsHaveTheirArea()
    {
        QFETCH(const int, index);
        const test::MeasurePhantom study = phantom(index);
        const bool uneven = !study.volume.geometry.slicePositions.empty();
        const glm::dvec3 centre(1.0, 2.0, -3.0);
        // What lies in one plane of a view may be bent between uneven slices; not so along axes.
        const glm::dvec3 right = uneven ? glm::dvec3(1, 0, 0) : along;
        const glm::dvec3 up = uneven ? glm::dvec3(0, 0, 1) : across;
        std::vector<glm::dvec3> outline;
        for (int i = 0; i < 400; ++i) {
            const double turn = 2.0 * M_PI * i / 400.0;
            outline.push_back(centre + 23.0 * std::cos(turn) * right + 11.0 * std::sin(turn) * up);
        }
        QVERIFY(agrees(sizeOf(study, Kind::Outline, outline).area, M_PI * 23.0 * 11.0));
        const std::vector<glm::dvec3> inSlice{
            centre, centre + glm::dvec3(20, 0, 0), centre + glm::dvec3(0, 7, 0)};
        const std::vector<glm::dvec3> oblique{centre, centre + 20.0 * along, centre + 7.0 * across};
        for (const std::vector<glm::dvec3>& points : {inSlice, oblique}) {
            if (uneven && points == oblique)
                continue;
            const MeasuredSize ellipse = sizeOf(study, Kind::Ellipse, points);
            QVERIFY(agrees(ellipse.area, M_PI * 20.0 * 7.0));
            QVERIFY(agrees(ellipse.longAxis, 40.0) && agrees(ellipse.shortAxis, 14.0));
            const MeasuredSize rectangle = sizeOf(study, Kind::Rectangle, points);
            QVERIFY(agrees(rectangle.area, 20.0 * 7.0));
            QVERIFY(agrees(rectangle.longAxis, 20.0) && agrees(rectangle.shortAxis, 7.0));
            QVERIFY(!rectangle.volume && !rectangle.length);
        }
    }

    /// A rectangle that stands on uneven slices is as high as they lie apart, and an ellipse is the
    /// sum of its narrow strips.
    void betweenUnevenSlicesAreasAddUp()
    {
        const test::MeasurePhantom study = phantom(3);
        const VolumeGeometry& geometry = study.volume.geometry;
        QVERIFY(!geometry.slicePositions.empty());
        const double low = -28.25;
        const double high = 27.5;
        QVERIFY(agrees(sizeOf(study, Kind::Rectangle,
                           {{-10.0, 4.0, low}, {14.0, 4.0, low}, {-10.0, 4.0, high}})
                           .area,
            24.0 * (high - low)));
        const glm::dvec3 centre(0.0, 4.0, 1.0); // as shown
        Measurement ellipse{.id = 1,
            .kind = Kind::Ellipse,
            .pointsLps = {centre, centre + glm::dvec3(12, 0, 0), centre + glm::dvec3(0, 0, 25)}};
        double area = 0.0;
        constexpr int strips = 200000;
        for (int i = 0; i < strips; ++i) {
            const double z = -25.0 + 50.0 * (i + 0.5) / strips;
            const double halfWidth = 12.0 * std::sqrt(1.0 - z * z / 625.0);
            const double k = geometry.toIndex(centre + glm::dvec3(0, 0, z)).z;
            const auto below = std::size_t(std::clamp(std::floor(k), 0.0, 23.0));
            const double stretch =
                (geometry.slicePositions[below + 1].z - geometry.slicePositions[below].z) / 2.5;
            area += 2.0 * halfWidth * stretch * 50.0 / strips;
        }
        QVERIFY(agrees(measuredSize(ellipse, study.volume).area, area));
        QVERIFY(std::abs(area - M_PI * 12.0 * 25.0) > 0.02 * area); // it makes a difference
    }

    /// 5 × 10 voxels and 4 slices of pixels of 0.5 mm whose distance nobody knows.
    void whatIsNotKnownIsInVoxels()
    {
        const glm::dvec3 at(0, 0, 2);
        const Measurement inSlice{
            .id = 1, .kind = Kind::Distance, .pointsLps = {at, at + glm::dvec3(1.5, 2.0, 0)}};
        const Measurement through{
            .id = 1, .kind = Kind::Distance, .pointsLps = {at, at + glm::dvec3(1.5, 0, 4.0)}};
        const Volume nothing = withProblem(ProblemCode::SpacingAssumed);
        QVERIFY(unknownSpacing(nothing) == UnknownSpacing::Everything);
        QVERIFY(measuredSize(inSlice, nothing).inVoxels);
        QCOMPARE(*measuredSize(inSlice, nothing).length, 5.0);
        QCOMPARE(*measuredSize(through, nothing).length, 5.0);
        const Volume depth = withProblem(ProblemCode::PicturesWithoutDistance);
        QVERIFY(unknownSpacing(depth) == UnknownSpacing::BetweenSlices);
        QVERIFY(!measuredSize(inSlice, depth).inVoxels);
        QCOMPARE(*measuredSize(inSlice, depth).length, 2.5);
        QVERIFY(measuredSize(through, depth).inVoxels);
        const Measurement ball{
            .id = 1, .kind = Kind::Ball, .pointsLps = {at, at + glm::dvec3(3, 0, 0)}};
        QVERIFY(agrees(measuredSize(ball, depth).volume, 4.0 / 3.0 * M_PI * 27.0 / 0.25));
        const Measurement area{.id = 1,
            .kind = Kind::Rectangle,
            .pointsLps = {at, at + glm::dvec3(2, 0, 0), at + glm::dvec3(0, 3, 0)}};
        QVERIFY(agrees(measuredSize(area, nothing).area, 4.0 * 6.0));
        QVERIFY(agrees(measuredSize(area, depth).area, 6.0));
        // The file of a single image says how thick it is; a stack may have been told.
        QVERIFY(
            unknownSpacing(withProblem(ProblemCode::DepthTakenFrom)) == UnknownSpacing::Nothing);
        Volume told = nothing;
        told.problems.front().repairedBy = QStringLiteral("spacing=0.5x0.5x1");
        QVERIFY(unknownSpacing(told) == UnknownSpacing::Nothing);
        QVERIFY(unknownSpacing(Volume()) == UnknownSpacing::Nothing);
    }

    /// Conjugate half diameters of a known ellipse, and points that span no plane.
    void halfAxesAndPlanes()
    {
        const double turn = 0.7;
        const glm::dvec3 a(8.0, 0, 0);
        const glm::dvec3 b(0, 3.0, 0);
        const glm::dvec2 axes = halfAxes(
            std::cos(turn) * a + std::sin(turn) * b, std::cos(turn) * b - std::sin(turn) * a);
        QVERIFY(agrees(axes.x, 8.0) && agrees(axes.y, 3.0));
        const Measurement line{
            .id = 1, .kind = Kind::Ellipse, .pointsLps = {{0, 0, 0}, {5, 5, 5}, {7, 7, 7}}};
        QVERIFY(!planeShape(line));
        QVERIFY(!measuredSize(line, Volume()).area);
    }
};

BURIN_TEST(MeasuredSizeTest)

} // namespace measuredSizeTest

#include "MeasuredSizeTest.moc"
