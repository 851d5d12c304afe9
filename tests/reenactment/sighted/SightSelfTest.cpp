// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/lobes/PlaneOutlines.h"
#include "tests/reenactment/sighted/PenHand.h"
#include "tests/reenactment/sighted/SightedTable.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace sightSelfTest {

using namespace core;
using namespace reenact;

namespace {

constexpr double phantomScale = 0.6;

const OrganScene& scene()
{
    static const OrganScene made = organPhantom(Organ::Kidney, phantomScale);
    return made;
}

const VolumeGeometry& geometry()
{
    return scene().study.volume.geometry;
}

const Mask& organ()
{
    static const Mask made = scene().maskOf(Organ::Kidney);
    return made;
}

CuttingPlane slice(int at)
{
    return CuttingPlane::through(geometry(), geometry().toWorld(glm::dvec3(0.0, 0.0, double(at))),
        geometry().direction()[2]);
}

const TableRow& rowNamed(const char* number)
{
    return std::find_if(sightedRows().begin(), sightedRows().end(), [number](const auto& each) {
        return QLatin1String(each.row.number) == QLatin1String(number);
    })->row;
}

/// How far off readings are, point by point, along both axes of their planes: what has no error is
/// the contour of the same mask.
std::vector<double> errorsOf(const SeenPlane& view)
{
    std::vector<double> errors;
    for (std::size_t line = 0; line < view.readings.size(); ++line) {
        for (std::size_t i = 0; i < view.readings[line].size(); ++i) {
            const glm::dvec3 off = view.readings[line][i] - view.contours[line][i];
            errors.push_back(glm::dot(off, view.plane.rightLps));
            errors.push_back(glm::dot(off, view.plane.downLps));
        }
    }
    return errors;
}

struct Moments {
    double mean = 0.0;
    double rms = 0.0;
};
Moments momentsOf(const std::vector<double>& values)
{
    Moments moments;
    for (const double value : values) {
        moments.mean += value / double(values.size());
        moments.rms += value * value / double(values.size());
    }
    moments.rms = std::sqrt(moments.rms);
    return moments;
}

} // namespace

/// What sighted robots see, and with what hand they draw: as unsteady as is said, and nothing of
/// the reference beyond the planes that were opened.
class SightSelfTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void readingsAreOffByOneMillimetre()
    {
        std::vector<double> errors;
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            Reader reader(scene().study, organ(), seed);
            for (int at = 0; at < geometry().size.z; ++at) {
                const std::vector<double> here = errorsOf(reader.look(slice(at), organ()));
                errors.insert(errors.end(), here.begin(), here.end());
            }
            QCOMPARE(reader.looks(), geometry().size.z);
        }
        QVERIFY(errors.size() > 10'000);
        const Moments moments = momentsOf(errors);
        QVERIFY2(std::abs(moments.mean) < 0.1, qPrintable(QString::number(moments.mean)));
        QVERIFY2(std::abs(moments.rms - 1.0) < 0.1, qPrintable(QString::number(moments.rms)));
    }

    /// Who could read a plane twice would have half the error.
    void aPlaneAlwaysReadsTheSame()
    {
        Reader reader(scene().study, organ(), 1);
        const int middle = geometry().size.z / 2;
        const SeenPlane first = reader.look(slice(middle), organ());
        const SeenPlane other = reader.look(slice(middle + 1), organ());
        const SeenPlane again = reader.look(slice(middle), organ());
        QVERIFY(!first.readings.empty());
        QVERIFY(first.readings == again.readings);
        // And the next one has another error.
        QVERIFY(std::abs(errorsOf(first).front() - errorsOf(other).front()) > 1e-3);
    }

    /// Without its errors, the organ that is imagined is the organ; with them it is neither larger
    /// nor smaller.
    void whatIsImaginedIsUnbiased()
    {
        constexpr int seeds = 6;
        double voxels = 0.0;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            Reader reader(scene().study, organ(), seed);
            const Inspection inspection(reader, geometry(), organ());
            voxels += double(countOf(inspection.organ())) / seeds;
        }
        const double share = voxels / double(countOf(organ()));
        QVERIFY2(std::abs(share - 1.0) < 0.02, qPrintable(QString::number(share)));
    }

    /// The reference is another one on slices that nobody opens: no robot can tell.
    void nothingIsKnownOfWhatWasNotOpened()
    {
        const TableRow& row = rowNamed("6");
        const Mask poor = corrupted(scene(), row, phantomScale, 1).mask;
        std::vector<bool> isOpened(std::size_t(geometry().size.z), false);
        {
            Reader reader(scene().study, organ(), 1);
            const Inspection inspection(reader, geometry(), poor);
            for (int at = 0; at < geometry().size.z; ++at)
                isOpened[std::size_t(at)] = inspection.hasOpened(at);
        }
        Mask other = organ();
        std::size_t changed = 0;
        for (std::size_t at = 0; at < other.values.size(); ++at) {
            const auto slice = at / (std::size_t(other.size.x) * std::size_t(other.size.y));
            if (isOpened[slice])
                continue;
            changed += other.values[at];
            other.values[at] = 0;
        }
        QVERIFY(changed > 500);
        for (const auto& run : {runSightedBrushRobot, runSightedSurfaceRobot}) {
            QStringList told;
            for (const Mask& reference : {organ(), other}) {
                RefinementBench bench(scene().study, poor);
                Reader reader(scene().study, reference, 1);
                const SightedRun made = run(bench, reader, {.mostActions = 4}, 1);
                QStringList steps;
                for (const SightedRun::Step& step : made.steps)
                    steps << step.what + QStringLiteral(" %1").arg(step.seen.voxelCount());
                QVERIFY(!steps.isEmpty());
                told << steps.join(QStringLiteral("; "));
            }
            QCOMPARE(told.last(), told.first());
        }
    }

    /// A contour that lies where the organ was read, but for the reader's own error, is no reason
    /// to do anything.
    void aSoundMaskIsLeftAlone()
    {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            for (const auto& run : {runSightedBrushRobot, runSightedSurfaceRobot}) {
                RefinementBench bench(scene().study, organ());
                Reader reader(scene().study, organ(), seed);
                const SightedRun made = run(bench, reader, {}, seed);
                QCOMPARE(made.actions(), 0);
                QVERIFY(made.looks > 0);
                QVERIFY(made.mask == runsOf(organ()));
            }
        }
    }

    void whatIsSeenIsMended()
    {
        const TableRow& row = rowNamed("6");
        const auto truth = Truth::of(organ(), geometry(), 12'000);
        QVERIFY(truth);
        const SightedAttempt made = attemptSighted(scene(), row, *truth, phantomScale, 1);
        for (const SightedOutcome& outcome : {made.surface, made.brush}) {
            const QString told = outcome.log.join(QStringLiteral("; "));
            QVERIFY2(outcome.after < 0.6 * made.before, qPrintable(told));
        }
        QVERIFY(made.surface.actions <= 12);
    }

    void handsTrembleAsIsSaid()
    {
        PenHand hand(geometry(), 3);
        const glm::dvec3 middle = geometry().toWorld(0.5 * glm::dvec3(geometry().size));
        const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 2.0, -1.0));
        constexpr double radiusMm = 12.0;
        std::vector<double> along;
        std::vector<double> outOfPlane;
        std::vector<double> radii;
        std::vector<double> rims;
        std::vector<double> steps;
        for (int i = 0; i < 4000; ++i) {
            const std::vector<glm::dvec3> stroke{middle, middle + glm::dvec3(0.5, 0.0, 0.0)};
            const std::vector<glm::dvec3> drawn = hand.drawn(stroke);
            for (int axis = 0; axis < 3; ++axis) {
                along.push_back(drawn[0][axis] - stroke[0][axis]);
                steps.push_back((drawn[1] - drawn[0] - (stroke[1] - stroke[0]))[axis]);
            }
            outOfPlane.push_back(glm::dot(hand.drawnOnPlane({middle}, normal)[0] - middle, normal));
            radii.push_back(hand.radiusMm(radiusMm) - radiusMm);
            const glm::dvec3 turned = hand.normal(normal, radiusMm);
            rims.push_back(radiusMm * glm::dot(turned, axisBeside(normal)));
        }
        for (const auto& values : {along, radii, rims}) {
            const Moments moments = momentsOf(values);
            QVERIFY2(std::abs(moments.mean) < 0.06, qPrintable(QString::number(moments.mean)));
            QVERIFY2(std::abs(moments.rms - 1.0) < 0.06, qPrintable(QString::number(moments.rms)));
        }
        QVERIFY(momentsOf(outOfPlane).rms < 1e-9);
        // It trembles slowly.
        QVERIFY2(momentsOf(steps).rms < 0.3, qPrintable(QString::number(momentsOf(steps).rms)));
    }

    /// Whether attraction is worth a try is seen in the picture alone.
    void edgesAreSeenInGreyValues()
    {
        const auto everywhere = [](const glm::dvec3&) { return true; };
        const int middle = geometry().size.z / 2;
        Reader reader(scene().study, organ(), 1);
        const double here = edgeShare(reader.look(slice(middle), organ()), everywhere);
        LoadedVolume flat = scene().study;
        std::fill(flat.codes.begin(), flat.codes.end(), std::uint16_t(1000));
        Reader blind(flat, organ(), 1);
        QCOMPARE(edgeShare(blind.look(slice(middle), organ()), everywhere), 0.0);
        QVERIFY2(here > 0.3, qPrintable(QString::number(here)));
    }
};

BURIN_TEST(SightSelfTest)

} // namespace sightSelfTest

#include "SightSelfTest.moc"
