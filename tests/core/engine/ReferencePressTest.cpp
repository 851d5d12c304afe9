// SPDX-License-Identifier: Apache-2.0
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/sculpt/SculptEdits.h"
#include "core/edits/sculpt/SculptVisit.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <cmath>
#include <variant>

namespace referencePressTest {

using namespace core;
using reference::ReferenceEngine;
using test::Bytes;

namespace {

constexpr double pressMm = 8.0;

/// A block of tissue in a volume that is seen along +z, with whatever spacing that way.
struct Bench {
    glm::ivec3 size;
    double sliceMm;
    Document document;
    OrthographicView view;
    double threshold = 0.5 * test::tissueCode;
    ReferenceEngine engine;

    /// @param firstSlice of the tissue
    Bench(const glm::ivec3& volumeSize, double slice, int firstSlice)
        : size(volumeSize)
        , sliceMm(slice)
    {
        Volume volume;
        volume.geometry.size = size;
        volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0),
            glm::dvec4(0, 0, slice, 0), glm::dvec4(0, 0, 0, 1));
        document = initialDocument(volume);
        view.targetLps = glm::dvec3(glm::dvec2(size) / 2.0 - 0.5, firstSlice * slice);
        view.eyeLps = view.targetLps - glm::dvec3(0, 0, 300);
        view.up = {0.0, 1.0, 0.0};
        (void)engine.openVolume(size, test::slab(size, 2, firstSlice, size.z - 1).values);
    }

    [[nodiscard]] SculptEdit edit(const QByteArray& tool) const
    {
        if (tool == "brush") {
            BrushStroke brush;
            brush.path.radiusMm = 6.3;
            brush.path.pointsLps = {view.targetLps + glm::dvec3(-4.2, 0.0, 1.0),
                view.targetLps + glm::dvec3(3.1, 2.0, 5.0)};
            return brush;
        }
        const std::vector<glm::dvec2> square{{-6, -6}, {6, -6}, {6, 6}, {-6, 6}};
        if (tool == "peel") {
            PeelCut peel{.view = view, .polygonMm = square};
            peel.depthMm = pressMm;
            peel.surfaceThreshold = threshold;
            return peel;
        }
        if (tool == "scissors") {
            ScissorsCut scissors{.view = view, .polygonMm = square};
            scissors.depthMm = pressMm;
            scissors.surfaceThreshold = threshold;
            return scissors;
        }
        if (tool == "laser")
            return pressed(LaserStroke{});
        return pressed(DrillStroke{});
    }

    EngineResult carryOut(const SculptEdit& edit)
    {
        visitSculpt([this](const auto& known) { submit(known); }, edit);
        return test::lastResult(engine);
    }

    [[nodiscard]] Bytes coverage()
    {
        reference::DenseFields fields = engine.fields();
        return fields.coverage(1);
    }
    /// Carved slices in the middle.
    [[nodiscard]] std::vector<int> carved()
    {
        const Bytes cut = coverage();
        std::vector<int> slices;
        for (int z = 0; z < size.z; ++z) {
            if (cut.at({size.x / 2, size.y / 2, z}) >= 128)
                slices.push_back(z);
        }
        return slices;
    }

private:
    template <class Pressed> [[nodiscard]] Pressed pressed(Pressed stroke) const
    {
        stroke.view = view;
        stroke.mask.radiusMm = 6.0;
        stroke.depthMm = pressMm;
        stroke.surfaceThreshold = threshold;
        stroke.samples = {{.pressure = 1.0}};
        return stroke;
    }
    void submit(const DrillStroke& stroke)
    {
        const DrillCut cut = *drillCut(stroke, document);
        submitWhole(engine, cut, {DrillPath{drillPath(stroke, cut)}});
    }
    void submit(const LaserStroke& stroke)
    {
        const LaserCut cut = *laserCut(stroke, document);
        submitWhole(engine, cut, {DrillPath{laserPath(stroke, cut)}});
    }
    void submit(const PeelCut& peel)
    {
        submitWhole(engine, *shellPeel(peel, document), {peelDepth(peel)});
    }
    void submit(const ScissorsCut& cut) { submitWhole(engine, *outlineCut(cut, document)); }
    void submit(const BrushStroke& stroke)
    {
        submitWhole(engine, *capsuleCut(stroke, document),
            {CapsulePath{capsules(stroke.path, document.volumes.front().geometry)}});
    }
};

} // namespace

/// What tools do that are pressed again, and backwards, on voxels of any shape.
class ReferencePressTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void goesDeeperEachTime_data()
    {
        QTest::addColumn<QByteArray>("tool");
        QTest::addColumn<double>("sliceMm");
        QTest::addColumn<double>("threshold");
        for (const char* tool : {"drill", "peel", "scissors"}) {
            for (const double slice : {1.0, 1.5, 3.0, 5.0, 8.0}) {
                for (const double part : {0.2, 0.5, 0.8})
                    QTest::addRow("%s, %g mm, threshold %g", tool, slice, part)
                        << QByteArray(tool) << slice << part;
            }
        }
    }
    void goesDeeperEachTime()
    {
        QFETCH(QByteArray, tool);
        QFETCH(double, sliceMm);
        QFETCH(double, threshold);
        constexpr int first = 4;
        Bench bench({26, 26, first + int(40.0 / sliceMm) + 4}, sliceMm, first);
        bench.threshold = threshold * test::tissueCode;
        const double surfaceMm = (first - 1 + threshold) * sliceMm;
        int deepest = first - 1;
        for (int press = 1; press <= 3; ++press) {
            (void)bench.carryOut(bench.edit(tool));
            const std::vector<int> carved = bench.carved();
            QVERIFY(!carved.empty());
            // Nothing of what was passed stands; in front of the surface at most a slice.
            QVERIFY(carved.front() <= first);
            if (tool != "laser")
                QVERIFY(carved.front() >= first - 1);
            QCOMPARE(carved.back() - carved.front() + 1, int(carved.size()));
            QVERIFY2(carved.back() > deepest, qPrintable(QString::number(press)));
            const double cutMm = (carved.back() + 0.5) * sliceMm - surfaceMm;
            const double allowed = 0.5 * sliceMm * press + 0.2;
            QVERIFY2(std::abs(cutMm - press * pressMm) <= allowed,
                qPrintable(QStringLiteral("press %1: %2 mm").arg(press).arg(cutMm)));
            deepest = carved.back();
        }
    }

    void cutsUpToTheBorder_data()
    {
        QTest::addColumn<QByteArray>("tool");
        QTest::addColumn<int>("slices");
        QTest::addColumn<double>("offMm");
        for (const char* tool : {"drill", "peel", "scissors"}) {
            for (const int slices : {1, 2, 3}) {
                for (const double off : {0.0, 0.1, 0.25, 0.5}) {
                    if (tool == QByteArrayLiteral("laser") && (off > 0.0 || slices != 2))
                        continue; // its normal is one of so thin a plate's edges too
                    QTest::addRow("%s, %d slices, %g mm", tool, slices, off)
                        << QByteArray(tool) << slices << off;
                }
            }
        }
    }
    /// All of it is tissue, and seen along x: there are `slices` columns of voxels side by side.
    void cutsUpToTheBorder()
    {
        QFETCH(QByteArray, tool);
        QFETCH(int, slices);
        QFETCH(double, offMm);
        Bench bench({20, 21, slices}, 1.0, 0);
        bench.view.targetLps = glm::dvec3(0.0, 10.0, (slices - 1) / 2.0 + offMm);
        bench.view.eyeLps = bench.view.targetLps - glm::dvec3(300, 0, 0);
        (void)bench.carryOut(bench.edit(tool));
        const Bytes cut = bench.coverage();
        for (int z = 0; z < slices; ++z) {
            for (int x = 0; x < 20; ++x) {
                // From the border of the volume, half a voxel before the first centre.
                const bool gone = cut.at({x, 10, z}) >= 128;
                QVERIFY2(gone == (x + 0.5 < pressMm),
                    qPrintable(QStringLiteral("slice %1, column %2").arg(z).arg(x)));
            }
        }
    }

    void cutsAllThereIs_data()
    {
        QTest::addColumn<QByteArray>("tool");
        for (const char* tool : {"drill", "peel", "scissors"})
            QTest::addRow("%s", tool) << QByteArray(tool);
    }
    /// Two slices of 6 mm are 12 mm of tissue.
    void cutsAllThereIs()
    {
        QFETCH(QByteArray, tool);
        for (const bool twice : {false, true}) {
            Bench bench({20, 21, 2}, 6.0, 0);
            (void)bench.carryOut(bench.edit(tool));
            QCOMPARE(bench.carved(), std::vector<int>{0});
            if (twice) {
                (void)bench.carryOut(bench.edit(tool));
                QCOMPARE(bench.carved(), (std::vector<int>{0, 1}));
            }
        }
    }

    void restoringGivesBackWhatWasCut_data()
    {
        QTest::addColumn<QByteArray>("tool");
        QTest::addColumn<double>("sliceMm");
        QTest::addColumn<double>("threshold");
        QTest::addColumn<double>("depthMm");
        QTest::addColumn<int>("times");
        for (const char* tool : {"drill", "peel", "scissors", "laser", "brush"}) {
            for (const double slice : {1.0, 1.5, 3.0, 5.0, 8.0}) {
                for (const double part : {0.2, 0.5, 0.8}) {
                    for (const double depth : {6.0, 20.0}) {
                        for (const int times : {1, 2}) {
                            // A second hole goes the way of the first one's floor, about.
                            const bool laser = tool == QByteArrayLiteral("laser");
                            if ((times > 1 && (depth > 10.0 || laser)) || (laser && depth < slice))
                                continue;
                            QTest::addRow("%s, %g mm, threshold %g, %g mm deep, %d", tool, slice,
                                part, depth, times)
                                << QByteArray(tool) << slice << part << depth << times;
                        }
                    }
                }
            }
        }
    }
    void restoringGivesBackWhatWasCut()
    {
        QFETCH(QByteArray, tool);
        QFETCH(double, sliceMm);
        QFETCH(double, threshold);
        QFETCH(double, depthMm);
        QFETCH(int, times);
        constexpr int first = 4;
        Bench bench({26, 26, first + int(24.0 / sliceMm) + 4}, sliceMm, first);
        bench.threshold = threshold * test::tissueCode;
        SculptEdit edit = bench.edit(tool);
        const auto set = [&](bool restore) {
            visitSculpt(
                [&](auto& known) {
                    known.restore = restore;
                    if constexpr (requires { known.depthMm; })
                        known.depthMm = depthMm;
                },
                edit);
        };
        set(false);
        for (int i = 0; i < times; ++i)
            (void)bench.carryOut(edit);
        const Bytes cut = bench.coverage();
        set(true);
        for (int i = 0; i < times; ++i)
            (void)bench.carryOut(edit);
        const Bytes left = bench.coverage();
        int carved = 0;
        for (int z = 0; z < bench.size.z; ++z) {
            for (int y = 0; y < bench.size.y; ++y) {
                for (int x = 0; x < bench.size.x; ++x) {
                    if (cut.at({x, y, z}) < 128)
                        continue;
                    // At the rim presses are shallower than a voxel, and so is what the first of
                    // two gives back.
                    const glm::dvec2 aside(x - 12.5, y - 12.5);
                    if (times > 1 && glm::length(aside) > 4.5)
                        continue;
                    ++carved;
                    QVERIFY2(left.at({x, y, z}) == 0,
                        qPrintable(QStringLiteral("%1 %2 %3: %4")
                                       .arg(x)
                                       .arg(y)
                                       .arg(z)
                                       .arg(left.at({x, y, z}))));
                }
            }
        }
        QVERIFY(carved > 20);
    }

    /// Restoring less than was cut leaves what lies above it.
    void restoresFromBelow()
    {
        for (const char* tool : {"drill", "peel", "scissors", "laser"}) {
            Bench bench({26, 26, 30}, 1.0, 4);
            SculptEdit edit = bench.edit(tool);
            (void)bench.carryOut(edit);
            QCOMPARE(bench.carved().back(), 11);
            visitSculpt(
                [](auto& known) {
                    known.restore = true;
                    if constexpr (requires { known.depthMm; })
                        known.depthMm = 3.0;
                },
                edit);
            (void)bench.carryOut(edit);
            QCOMPARE(bench.carved().back(), 8);
            (void)bench.carryOut(edit);
            QCOMPARE(bench.carved().back(), 5);
            (void)bench.carryOut(edit);
            QVERIFY(bench.carved().empty());
        }
    }
};

BURIN_TEST(ReferencePressTest)

} // namespace referencePressTest

#include "ReferencePressTest.moc"
