// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/AnyEdit.h"
#include "core/session/EditSession.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>

namespace badInputTest {

using namespace core;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

LoadedVolume volumeOf(const glm::ivec3& size, const glm::dvec3& spacing)
{
    test::Random random(4);
    LoadedVolume made;
    made.volume.geometry.size = size;
    made.volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(spacing.x, 0, 0, 0),
        glm::dvec4(0, spacing.y, 0, 0), glm::dvec4(0, 0, spacing.z, 0), glm::dvec4(0, 0, 0, 1));
    made.volume.minimum = 0.0;
    made.volume.maximum = 65535.0;
    made.volume.voxelsSha256 = "not looked at here";
    made.codes = test::balls(size, 6, random).values;
    return made;
}

/// The tools, each with a stroke that cuts a good volume.
std::vector<std::pair<QByteArray, Edit>> strokesAt(const VolumeGeometry& geometry)
{
    const glm::dvec3 middle = geometry.toWorld(glm::dvec3(geometry.size - 1) / 2.0);
    OrthographicView view;
    view.targetLps = middle;
    view.eyeLps = middle - glm::dvec3(0.0, 0.0, 300.0);
    view.up = {0.0, 1.0, 0.0};
    const double threshold = test::tissueCode / 2;
    DrillStroke drill;
    drill.view = view;
    drill.mask.radiusMm = 6.0;
    drill.surfaceThreshold = threshold;
    drill.samples = {{-8, 0, 1, 0}, {8, 4, 0.7, 0.5}};
    DrillStroke rate = drill;
    rate.mode = DrillMode::Rate;
    rate.mask.kind = ToolMask::Kind::Square;
    LaserStroke laser;
    laser.view = view;
    laser.mask = drill.mask;
    laser.surfaceThreshold = threshold;
    laser.samples = drill.samples;
    PeelCut peel;
    peel.view = view;
    peel.polygonMm = {{-12, -12}, {12, -12}, {12, 12}, {-12, 12}};
    peel.surfaceThreshold = threshold;
    ScissorsCut scissors;
    scissors.view = view;
    scissors.polygonMm = peel.polygonMm;
    scissors.surfaceThreshold = threshold;
    scissors.depthMm = 5.0;
    BrushStroke brush;
    brush.path.radiusMm = 5.0;
    brush.path.pointsLps = {middle, middle + glm::dvec3(6.0, 3.0, 0.0)};
    PaintStroke paint{.segment = 1};
    paint.path = brush.path;
    return {{"drill", drill}, {"drill by time", rate}, {"laser", laser}, {"peel", peel},
        {"scissors", scissors}, {"brush", brush}, {"paint", paint}};
}

OrthographicView* viewOf(Edit& edit)
{
    if (auto* drill = edit.as<DrillStroke>())
        return &drill->view;
    if (auto* laser = edit.as<LaserStroke>())
        return &laser->view;
    if (auto* peel = edit.as<PeelCut>())
        return &peel->view;
    auto* scissors = edit.as<ScissorsCut>();
    return scissors ? &scissors->view : nullptr;
}

std::vector<PenSample>* samplesOf(Edit& edit)
{
    if (auto* drill = edit.as<DrillStroke>())
        return &drill->samples;
    auto* laser = edit.as<LaserStroke>();
    return laser ? &laser->samples : nullptr;
}

BrushPath* pathOf(Edit& edit)
{
    if (auto* brush = edit.as<BrushStroke>())
        return &brush->path;
    auto* paint = edit.as<PaintStroke>();
    return paint ? &paint->path : nullptr;
}

ToolMask* maskOf(Edit& edit)
{
    if (auto* drill = edit.as<DrillStroke>())
        return &drill->mask;
    auto* laser = edit.as<LaserStroke>();
    return laser ? &laser->mask : nullptr;
}

std::vector<glm::dvec2>* outlineOf(Edit& edit)
{
    if (auto* peel = edit.as<PeelCut>())
        return &peel->polygonMm;
    auto* scissors = edit.as<ScissorsCut>();
    return scissors ? &scissors->polygonMm : nullptr;
}

enum class End { Refused, Nothing, Either };

/// What is wrong with a stroke, and what must come of it.
struct Trouble {
    const char* name;
    End end;
    std::function<bool(Edit&)> spoil; ///< false: it means nothing to this tool
};

std::vector<Trouble> troubles()
{
    return {
        {"off the volume", End::Nothing,
            [](Edit& edit) {
                if (OrthographicView* view = viewOf(edit)) {
                    view->targetLps.x += 200.0;
                    view->eyeLps.x += 200.0;
                } else {
                    for (glm::dvec3& point : pathOf(edit)->pointsLps)
                        point.x += 200.0;
                }
                return true;
            }},
        {"zero radius", End::Refused,
            [](Edit& edit) {
                if (ToolMask* mask = maskOf(edit)) {
                    mask->kind = ToolMask::Kind::Circle;
                    mask->radiusMm = 0.0;
                } else if (std::vector<glm::dvec2>* outline = outlineOf(edit)) {
                    for (glm::dvec2& point : *outline)
                        point = glm::dvec2(0.0);
                } else {
                    pathOf(edit)->radiusMm = 0.0;
                }
                return true;
            }},
        {"not a number", End::Refused,
            [](Edit& edit) {
                if (std::vector<PenSample>* samples = samplesOf(edit))
                    samples->back().pressure = nan;
                else if (std::vector<glm::dvec2>* outline = outlineOf(edit))
                    outline->back().x = nan;
                else
                    pathOf(edit)->pointsLps.back().y = nan;
                return true;
            }},
        {"the eye in the volume", End::Either,
            [](Edit& edit) {
                OrthographicView* view = viewOf(edit);
                if (view)
                    view->eyeLps = view->targetLps - glm::dvec3(0.0, 0.0, 0.5);
                return view != nullptr;
            }},
        {"the eye at the target", End::Refused,
            [](Edit& edit) {
                OrthographicView* view = viewOf(edit);
                if (view)
                    view->eyeLps = view->targetLps;
                return view != nullptr;
            }},
        {"up along the view", End::Refused,
            [](Edit& edit) {
                OrthographicView* view = viewOf(edit);
                if (view)
                    view->up = {0.0, 0.0, 1.0};
                return view != nullptr;
            }},
        {"all of it hidden", End::Nothing,
            [](Edit& edit) {
                const ClipHalfSpaces all = {{{{0.0, 0.0, 1.0}, -1000.0}}};
                return visitEdit(
                    [&all](auto& known) {
                        if constexpr (requires { known.hidden; }) {
                            known.hidden = all;
                            return true;
                        }
                        return false;
                    },
                    edit);
            }},
        {"nothing wrong", End::Either, [](Edit&) { return true; }},
    };
}

} // namespace

/// Issue 4: whatever a stroke is given, the document stays sound and the history has no row too
/// many.
class BadInputTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void leavesASoundDocument_data()
    {
        QTest::addColumn<glm::ivec3>("size");
        QTest::addColumn<glm::dvec3>("spacing");
        QTest::addRow("cube") << glm::ivec3(36, 36, 30) << glm::dvec3(1.0);
        QTest::addRow("two slices") << glm::ivec3(36, 36, 2) << glm::dvec3(1.0);
        QTest::addRow("8 : 1") << glm::ivec3(36, 36, 6) << glm::dvec3(1.0, 1.0, 8.0);
    }
    void leavesASoundDocument()
    {
        QFETCH(glm::ivec3, size);
        QFETCH(glm::dvec3, spacing);
        reference::ReferenceEngine engine;
        const LoadedVolume volume = volumeOf(size, spacing);
        for (const Trouble& trouble : troubles()) {
            for (const auto& [tool, stroke] : strokesAt(volume.volume.geometry)) {
                Edit edit = stroke;
                if (!trouble.spoil(edit))
                    continue;
                auto session = EditSession::create(engine, volume, {});
                QVERIFY(session);
                QVERIFY((*session)->apply(
                    AddSegment{.name = QStringLiteral("One"), .rgb = 0xFF0000, .code = {}}));
                QVERIFY((*session)->settle());
                const QByteArray before = (*session)->stateHash();
                const QByteArray what = tool + ", " + trouble.name;

                const Result<void> applied = (*session)->apply(edit);
                QVERIFY2((*session)->settle(), what.constData());
                const bool changed = (*session)->stateHash() != before;
                const std::size_t rows = (*session)->history().rows().size();
                QCOMPARE(rows, std::size_t(changed ? 2 : 1));
                QVERIFY2(applied || !changed, what.constData());
                if (trouble.end == End::Refused)
                    QVERIFY2(!applied, what.constData());
                else if (trouble.end == End::Nothing)
                    QVERIFY2(!changed, what.constData());
                if (changed) {
                    QVERIFY((*session)->undo());
                    QVERIFY((*session)->settle());
                    QVERIFY2((*session)->stateHash() == before, what.constData());
                }
                // It goes on working.
                QVERIFY((*session)->apply(strokesAt(volume.volume.geometry).back().second));
                QVERIFY2((*session)->settle(), what.constData());
            }
        }
    }

    /// However events come in batches, and however often a tablet repeats one.
    void batchesAndRepeatedEventsDoNotMatter_data()
    {
        QTest::addColumn<bool>("laser");
        QTest::addColumn<bool>("rate");
        for (const bool laser : {false, true}) {
            for (const bool rate : {false, true})
                QTest::addRow("%s, %s", laser ? "laser" : "drill", rate ? "rate" : "limit")
                    << laser << rate;
        }
    }
    void batchesAndRepeatedEventsDoNotMatter()
    {
        QFETCH(bool, laser);
        QFETCH(bool, rate);
        const LoadedVolume volume = volumeOf({36, 36, 30}, glm::dvec3(1.0));
        reference::ReferenceEngine engine;
        test::Random random(laser ? 8 : 9);
        QByteArray expected;
        std::vector<PenSample> path;
        for (int i = 0; i < 40; ++i) {
            const double t = i / 60.0;
            path.push_back({16.0 * t - 8.0, 5.0 * std::sin(6.0 * t), 0.4 + 0.6 * t, t});
        }
        for (int round = 0; round < 6; ++round) {
            Edit edit = strokesAt(volume.volume.geometry)[laser ? 2 : 0].second;
            const auto prepare = [rate](auto& stroke) {
                stroke.samples.clear();
                stroke.byTime = true;
                stroke.mode = rate ? DrillMode::Rate : DrillMode::Limit;
            };
            if (laser)
                prepare(edit.get<LaserStroke>());
            else
                prepare(edit.get<DrillStroke>());
            auto session = EditSession::create(engine, volume, {});
            QVERIFY(session);
            QVERIFY((*session)->begin(edit));
            std::vector<PenSample> batch;
            for (const PenSample& sample : path) {
                batch.push_back(sample);
                if (round > 0 && random() % 3 == 0)
                    batch.push_back(sample); // told twice
                if (round > 0 && random() % 3 == 0) {
                    (*session)->extend(PenSamples{.samples = batch});
                    batch.clear();
                    if (random() % 2)
                        (*session)->poll();
                }
            }
            (*session)->extend(PenSamples{.samples = batch});
            (*session)->end(Ending::Commit);
            QVERIFY((*session)->settle());
            QCOMPARE((*session)->history().rows().size(), std::size_t(1));
            if (expected.isEmpty())
                expected = (*session)->stateHash();
            QCOMPARE((*session)->stateHash(), expected);
        }
    }
};

BURIN_TEST(BadInputTest)

} // namespace badInputTest

#include "BadInputTest.moc"
