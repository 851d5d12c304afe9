// SPDX-License-Identifier: Apache-2.0
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/SegmentSeen.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <cmath>

namespace layerEditsTest {

using namespace core;

class LayerEditsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Whole numbers say of every voxel what doubles say, but for those as near as rounding.
    void boundsAreThePlanes()
    {
        int near = 0;
        int inside = 0;
        const int count = test::longRun() ? 2000 : 100;
        for (int number = 0; number < count; ++number) {
            test::Random random{std::uint32_t(500 + number)};
            const glm::ivec3 size{test::randomInt(random, 1, 700), test::randomInt(random, 1, 512),
                test::randomInt(random, 1, 300)};
            Document document = test::randomDocument(size, random, number % 2 != 0);
            const VolumeGeometry& geometry = document.volumes.front().geometry;
            SegmentSeen seen{.target = {.name = QStringLiteral("X")}};
            const glm::dvec3 normal{test::randomUnit(random), test::randomUnit(random),
                test::randomUnit(random) + 0.01};
            const glm::dvec3 at(test::randomVoxel(random, size));
            seen.hidden = {{test::beyond(geometry.toWorld(at), normal)}};
            const Result<LabelSeen> made = labelSeen(seen, document);
            QVERIFY(made);
            QCOMPARE(made->bounds.size(), std::size_t(1));
            QVERIFY(checkSound(*made, BrickGrid{size}));
            const VoxelBound& bound = made->bounds.front();
            for (int i = 0; i < 200; ++i) {
                const glm::ivec3 voxel = test::randomVoxel(random, size);
                const double beyondMm =
                    glm::dot(normal, geometry.toWorld(glm::dvec3(voxel)) - geometry.toWorld(at))
                    / glm::length(normal);
                if (std::abs(beyondMm) < 0.01 * geometry.spacingMm().x) {
                    ++near;
                    continue;
                }
                std::int64_t sum = 0;
                for (int axis = 0; axis < 3; ++axis)
                    sum += std::int64_t(bound.normal[axis]) * voxel[axis];
                QCOMPARE(sum <= bound.offset, beyondMm < 0.0);
                inside += beyondMm < 0.0 ? 1 : 0;
            }
        }
        QVERIFY(near < 2 * count);
        QVERIFY(inside > 20 * count && inside < 180 * count);
    }

    /// A plane through the middle of a slice hides the next one, and not that one.
    void slicesAreMetExactly()
    {
        test::Random random{3};
        const Document document = test::randomDocument({60, 50, 40}, random, false);
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        for (int axis = 0; axis < 3; ++axis) {
            for (int slice = 0; slice < 40; ++slice) {
                glm::dvec3 at(20.0);
                at[axis] = slice;
                SegmentSeen seen{.target = {.name = QStringLiteral("X")}};
                seen.hidden = {{test::beyond(geometry.toWorld(at), geometry.direction()[axis])}};
                const VoxelBound bound = labelSeen(seen, document)->bounds.front();
                QCOMPARE(bound.normal[(axis + 1) % 3], 0);
                QCOMPARE(bound.normal[(axis + 2) % 3], 0);
                QVERIFY(bound.normal[axis] * slice <= bound.offset);
                QVERIFY(bound.normal[axis] * (slice + 1) > bound.offset);
            }
        }
    }

    void targetsAreToldApart()
    {
        test::Random random{4};
        Document document = test::randomDocument({9, 9, 9}, random, false);
        document.layers = {{.id = 1, .name = QStringLiteral("Sculpt 1")}};
        document.segments = {{.label = 1, .name = QStringLiteral("Free")},
            {.label = 3, .name = QStringLiteral("Locked"), .locked = true}};
        document.greatestRemovedLabel = 5;
        const LabelCarved fresh = *labelCarved(
            {.layer = 1, .target = {.name = QStringLiteral("New")}, .overwriteUnlocked = true},
            document);
        QCOMPARE(int(fresh.target.label), 6);
        QVERIFY(fresh.target.overwritable[1] && !fresh.target.overwritable[3]);
        QCOMPARE(
            int(labelCarved({.layer = 1, .target = {.segment = 1}}, document)->target.label), 1);
        const auto code = [&](const LayerToSegment& edit) {
            return checkAgainst(document, edit).error().code;
        };
        QCOMPARE(code({.layer = 1, .target = {.segment = 3}}), ErrorCode::SegmentLocked);
        QCOMPARE(code({.layer = 1, .target = {.segment = 2}}), ErrorCode::UnknownSegment);
        QCOMPARE(code({.layer = 2, .target = {.segment = 1}}), ErrorCode::InvalidField);
        const SegmentSeen nothing{.target = {.segment = 1}, .lower = 5.0, .upper = 4.0};
        QCOMPARE(checkAgainst(document, nothing).error().code, ErrorCode::InvalidField);
    }

    void anInversionSwapsWithWhatIsFree()
    {
        test::Random random{6};
        Document document = test::randomDocument({9, 9, 9}, random, false);
        document.segments = {{.label = 1, .name = QStringLiteral("Free")},
            {.label = 3, .name = QStringLiteral("Locked"), .locked = true},
            {.label = 255, .plane = 1, .name = QStringLiteral("Elsewhere")}};
        const MapLabels map = *mapLabels(InvertSegment{.segment = 1}, document);
        QCOMPARE(int(map.plane), 0);
        for (std::size_t label = 0; label < 256; ++label)
            QCOMPARE(std::size_t(map.becomes[label]), label < 2 ? 1 - label : label);
        const MapLabels last = *mapLabels(InvertSegment{.segment = 255}, document);
        QCOMPARE(int(last.plane), 1);
        QVERIFY(last.becomes[0] == 255 && last.becomes[255] == 0 && last.becomes[1] == 1);
        const auto code = [&](int segment) {
            return checkAgainst(document, InvertSegment{.segment = segment}).error().code;
        };
        QCOMPARE(code(3), ErrorCode::SegmentLocked);
        QCOMPARE(code(2), ErrorCode::UnknownSegment);
        QVERIFY(checkAgainst(document, InvertSegment{.segment = 1}));
    }

    /// Both segments are of one label plane, and every other label of it stays.
    void segmentsAreCombinedWithinTheirPlane()
    {
        test::Random random{7};
        Document document = test::randomDocument({9, 9, 9}, random, false);
        document.segments = {{.label = 1, .name = QStringLiteral("One")},
            {.label = 3, .name = QStringLiteral("Locked"), .locked = true},
            {.label = 4, .plane = 1, .name = QStringLiteral("Elsewhere")},
            {.label = 7, .name = QStringLiteral("Two")},
            {.label = 255, .plane = 1, .name = QStringLiteral("There, too")}};
        using How = CombineSegments::How;
        for (const How how : {How::Merge, How::Swap}) {
            const MapLabels map =
                *mapLabels(CombineSegments{.segment = 1, .with = 7, .how = how}, document);
            QCOMPARE(int(map.plane), 0);
            for (std::size_t label = 0; label < 256; ++label) {
                const bool back = label == 1 && how == How::Swap;
                QCOMPARE(std::size_t(map.becomes[label]), label == 7 ? 1 : back ? 7 : label);
            }
            const MapLabels there =
                *mapLabels(CombineSegments{.segment = 255, .with = 4, .how = how}, document);
            QCOMPARE(int(there.plane), 1);
            QCOMPARE(int(there.becomes[4]), 255);
            QCOMPARE(int(there.becomes[255]), how == How::Swap ? 4 : 255);
            const auto code = [&](int segment, int with) {
                return checkAgainst(
                    document, CombineSegments{.segment = segment, .with = with, .how = how})
                    .error()
                    .code;
            };
            if (how == How::Swap) { // of another plane
                QCOMPARE(code(1, 4), ErrorCode::InvalidField);
                QCOMPARE(code(255, 7), ErrorCode::InvalidField);
            }
            QCOMPARE(code(1, 3), ErrorCode::SegmentLocked);
            QCOMPARE(code(3, 1), ErrorCode::SegmentLocked);
            QCOMPARE(code(1, 2), ErrorCode::UnknownSegment);
            QVERIFY(checkAgainst(document, CombineSegments{.segment = 7, .with = 1, .how = how}));
        }
    }

    /// The segment's plane comes first, whichever that is; what is asked of the other one is asked
    /// as of an editable range.
    void mergesOfTwoPlanes()
    {
        test::Random random{7};
        Document document = test::randomDocument({9, 9, 9}, random, false);
        document.segments = {{.label = 3, .name = QStringLiteral("Locked"), .locked = true},
            {.label = 4, .plane = 1, .name = QStringLiteral("Elsewhere")},
            {.label = 7, .name = QStringLiteral("Here")}};
        for (const auto& [into, from] : {std::pair{4, 7}, std::pair{7, 4}}) {
            const CombineSegments edit{.segment = into, .with = from};
            const Result<EngineEdit> command = engineEdit(edit, document);
            QVERIFY(command && std::holds_alternative<MapPlanes>(*command));
            const std::vector<MapLabels>& planes = std::get<MapPlanes>(*command).planes;
            QCOMPARE(planes.size(), std::size_t(2));
            for (const bool first : {true, false}) {
                const MapLabels& map = planes[first ? 0 : 1];
                const int own = first ? into : from;
                const int beside = first ? from : into;
                QCOMPARE(int(map.plane), own == 4 ? 1 : 0);
                for (std::size_t label = 0; label < 256; ++label) {
                    const std::size_t expected = first && label == 0 ? std::size_t(own)
                        : !first && label == std::size_t(own)        ? 0
                                                                     : label;
                    QCOMPARE(std::size_t(map.becomes[label]), expected);
                }
                QVERIFY(map.editable && map.editable->inside && map.editable->outside.empty());
                QCOMPARE(map.editable->inside->size(), std::size_t(1));
                QCOMPARE(int(map.editable->inside->front().plane), beside == 4 ? 1 : 0);
                QVERIFY(map.editable->inside->front().labels.count() == 1
                    && map.editable->inside->front().labels[std::size_t(beside)]);
            }
        }
        const auto code = [&](CombineSegments edit) {
            return checkAgainst(document, edit).error().code;
        };
        QCOMPARE(code({.segment = 4, .with = 3}), ErrorCode::SegmentLocked);
        QCOMPARE(code({.segment = 3, .with = 4}), ErrorCode::SegmentLocked);
        const EditableRange inside{.inside = std::vector<int>{7}};
        QCOMPARE(code({.segment = 4, .with = 7, .editable = inside}), ErrorCode::InvalidField);
        const EditableRange outside{.outside = std::vector<int>{4}};
        QCOMPARE(code({.segment = 4, .with = 7, .editable = outside}), ErrorCode::InvalidField);
        const EditableRange other{.outside = std::vector<int>{3}};
        QVERIFY(
            checkAgainst(document, CombineSegments{.segment = 4, .with = 7, .editable = other}));
    }
};

BURIN_TEST(LayerEditsTest)

} // namespace layerEditsTest

#include "LayerEditsTest.moc"
