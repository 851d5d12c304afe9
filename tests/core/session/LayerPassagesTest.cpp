// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/layers/MergeLayers.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/edits/kinds/parts/SegmentChoice.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/SegmentSeen.h"
#include "core/session/EditSession.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <algorithm>

namespace layerPassagesTest {

using namespace core;

namespace {

const SegmentChoice toNew{.name = QStringLiteral("Carved"), .rgb = 0x4080C0};

struct Bench {
    explicit Bench(const std::vector<Edit>& edits)
    {
        session = *EditSession::create(engine, test::smallStudy(), {});
        for (const Edit& edit : edits)
            run(edit);
    }
    void run(const Edit& edit)
    {
        const QString why = tried(edit);
        QVERIFY2(why.isEmpty(), qPrintable(why));
    }
    /// @return why it was refused, at once or later; empty if it was not
    QString tried(const Edit& edit)
    {
        Result<void> done = session->apply(edit);
        if (done)
            done = session->settle();
        return done ? QString() : done.error().arguments.join(QStringLiteral(": "));
    }
    [[nodiscard]] QString lastName() const { return session->history().rows().back().name; }
    [[nodiscard]] std::size_t rows() const { return session->history().rows().size(); }
    [[nodiscard]] std::vector<std::uint8_t> coverage(std::uint8_t layer) const
    {
        reference::DenseFields fields = engine.fields();
        return fields.coverage(layer).values;
    }
    [[nodiscard]] std::vector<std::uint8_t> labels() const
    {
        reference::DenseFields fields = engine.fields();
        return fields.labels(0).values;
    }
    [[nodiscard]] std::uint8_t labelAt(const glm::ivec3& voxel) const
    {
        reference::DenseFields fields = engine.fields();
        return fields.labels(0).at(voxel);
    }

    reference::ReferenceEngine engine;
    std::unique_ptr<EditSession> session;
};

Edit drillInto(int layer, double xMm = 0)
{
    return test::drillWith({.layer = layer}, test::drillAt(xMm));
}

const Edit second = AddLayer{.name = QStringLiteral("Approach")};

} // namespace

class LayerPassagesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void rowsHaveNamesForPeople()
    {
        Bench bench({second, drillInto(1), LayerToSegment{.layer = 1, .target = toNew}});
        QVERIFY2(
            bench.lastName().startsWith(QStringLiteral("Layer 'Sculpt 1' to segment 'Carved', +")),
            qPrintable(bench.lastName()));
        bench.run(SegmentToLayer{.segment = 1, .layer = 2});
        QVERIFY(
            bench.lastName().startsWith(QStringLiteral("Segment 'Carved' to layer 'Approach', ")));
        bench.run(SegmentSeen{.target = {.segment = 1}, .lower = 500.0});
        QVERIFY(bench.lastName().startsWith(QStringLiteral("Segment what is seen as 'Carved', +")));
        bench.run(ChangeLayer{.layer = 2, .solo = true});
        QCOMPARE(bench.lastName(), QStringLiteral("Solo layer 'Approach'"));
        bench.run(ChangeLayer{.layer = 2, .solo = false});
        QCOMPARE(bench.lastName(), QStringLiteral("End solo of layer 'Approach'"));
        bench.run(MergeLayers{.from = 2, .into = 1});
        QCOMPARE(bench.lastName(), QStringLiteral("Merge layer 'Approach' into 'Sculpt 1'"));
        bench.run(second);
        QCOMPARE(int(bench.session->document().layers.back().id), 3); // 2 is not given again
        bench.run(RemoveLayer{.layer = 1});
        QCOMPARE(bench.lastName(), QStringLiteral("Delete layer 'Sculpt 1'"));
    }

    /// Members are what the layer covers by half and more, and nothing else.
    void whatIsCarvedBecomesASegment()
    {
        Bench bench({drillInto(1), LayerToSegment{.layer = 1, .target = toNew}});
        const std::vector<std::uint8_t> coverage = bench.coverage(1);
        const std::vector<std::uint8_t> labels = bench.labels();
        std::int64_t members = 0;
        int partly = 0;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            QCOMPARE(int(labels[i]), coverage[i] >= 128 ? 1 : 0);
            members += labels[i];
            partly += coverage[i] > 0 && coverage[i] < 128 ? 1 : 0;
        }
        QVERIFY(members > 0 && partly > 0);
        QCOMPARE(bench.session->document().segments.front().voxels, members);
        QCOMPARE(bench.session->document().segments.front().name, QStringLiteral("Carved"));
        // And back: what was cut in part is whole now.
        bench.run(second);
        bench.run(SegmentToLayer{.segment = 1, .layer = 2});
        const std::vector<std::uint8_t> covered = bench.coverage(2);
        for (std::size_t i = 0; i < labels.size(); ++i)
            QCOMPARE(int(covered[i]), labels[i] == 1 ? 255 : 0);
    }

    /// All but a segment is carved, to the corners of the volume; what is protected is not.
    void allButASegmentIsCarved()
    {
        Bench bench({drillInto(1), LayerToSegment{.layer = 1, .target = toNew}});
        bench.run(second);
        bench.run(test::addSegment("Spared"));
        bench.run(test::paintAt(2, test::pointsInBrain(), 1.5)); // the bone there is carved
        bench.run(ChangeSegment{.segment = 2, .uncarvable = true});
        bench.run(SegmentToLayer{.segment = 1, .layer = 2, .outside = true});
        QVERIFY2(bench.lastName().startsWith(
                     QStringLiteral("All but segment 'Carved' to layer 'Approach', ")),
            qPrintable(bench.lastName()));
        const std::vector<std::uint8_t> labels = bench.labels();
        const std::vector<std::uint8_t> covered = bench.coverage(2);
        QVERIFY(std::count(labels.begin(), labels.end(), 2) > 0);
        for (std::size_t i = 0; i < labels.size(); ++i)
            QCOMPARE(int(covered[i]), labels[i] == 0 ? 255 : 0);
        QVERIFY(bench.session->undo() && bench.session->settle());
        const std::vector<std::uint8_t> before = bench.coverage(2);
        QVERIFY(std::all_of(before.begin(), before.end(), [](int each) { return each == 0; }));
    }

    void othersKeepTheirVoxels()
    {
        const std::vector<Edit> before{test::addSegment("Bone"), test::seedInBone(1),
            test::growBone(), test::addSegment("Cut"), drillInto(1)};
        Bench shy(before);
        const std::vector<std::uint8_t> grown = shy.labels();
        shy.run(LayerToSegment{.layer = 1, .target = {.segment = 2}});
        Bench bold(before);
        bold.run(LayerToSegment{.layer = 1, .target = {.segment = 2}, .overwriteUnlocked = true});
        Bench locked(before);
        locked.run(test::lockSegment(1));
        locked.run(LayerToSegment{.layer = 1, .target = {.segment = 2}, .overwriteUnlocked = true});
        QVERIFY(shy.labels() == locked.labels());
        QVERIFY(shy.labels() != bold.labels());
        for (std::size_t i = 0; i < grown.size(); ++i) {
            if (grown[i] == 1)
                QCOMPARE(int(shy.labels()[i]), 1);
        }
        QVERIFY(!locked.tried(LayerToSegment{.layer = 1, .target = {.segment = 1}}).isEmpty());
    }

    /// What is seen ends at cuts, at the threshold and at the clip region's sides.
    void whatIsSeenBecomesASegment()
    {
        const VolumeGeometry geometry = test::smallStudy().volume.geometry;
        SegmentSeen seen{.target = toNew, .lower = 500.0};
        seen.hidden = {{{glm::dvec3(0, 0, 1), geometry.toWorld({20, 18, 17}).z}}};
        Bench bench({drillInto(1), seen});
        const std::vector<std::uint8_t> coverage = bench.coverage(1);
        const std::vector<std::uint8_t> labels = bench.labels();
        const std::vector<std::uint16_t> codes = test::smallStudy().codes;
        int members = 0;
        std::size_t i = 0;
        for (int z = 0; z < geometry.size.z; ++z) {
            for (int rest = 0; rest < geometry.size.x * geometry.size.y; ++rest, ++i) {
                // The plane goes through slice 17, which is not hidden by it.
                const bool wanted = codes[i] - 1024 >= 500 && coverage[i] < 128 && z <= 17;
                QCOMPARE(int(labels[i]), wanted ? 1 : 0);
                members += wanted ? 1 : 0;
            }
        }
        QVERIFY(members > 0);
        // A muted layer hides nothing.
        Bench muted({drillInto(1), ChangeLayer{.layer = 1, .muted = true}, seen});
        QVERIFY(muted.session->document().segments.front().voxels > members);
    }

    void whatChangesNothingLeavesNoRow()
    {
        Bench bench({test::addSegment("Empty"), second});
        const QByteArray before = bench.session->stateHash();
        bench.run(LayerToSegment{.layer = 1, .target = toNew});
        bench.run(LayerToSegment{.layer = 1, .target = {.segment = 1}});
        bench.run(SegmentToLayer{.segment = 1, .layer = 2});
        bench.run(SegmentSeen{.target = toNew, .lower = 1e6});
        bench.run(ChangeLayer{.layer = 1, .solo = false});
        QCOMPARE(bench.rows(), std::size_t(2));
        QCOMPARE(bench.session->stateHash(), before);
        QCOMPARE(bench.session->document().segments.size(), std::size_t(1));
    }

    /// While a layer is solo the others are as if muted.
    void soloLeavesOthersOut()
    {
        const auto alone = Bench({second, drillInto(2)}).coverage(2);
        Bench bench({second, drillInto(1), ChangeLayer{.layer = 2, .solo = true}, drillInto(2)});
        QVERIFY(bench.coverage(2) == alone);
        QVERIFY(bench.tried(drillInto(1)).contains(QStringLiteral("another is solo")));
        bench.run(ChangeLayer{.layer = 1, .solo = true});
        bench.run(drillInto(1, 3.0));
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QVERIFY(!bench.tried(drillInto(1)).isEmpty());
    }

    void mergingLooksTheSame()
    {
        Bench bench({second, drillInto(1), drillInto(2, 4.0)});
        const std::vector<std::uint8_t> seen = bench.engine.carved().values;
        bench.run(MergeLayers{.from = 1, .into = 2});
        QVERIFY(bench.engine.carved().values == seen);
        QVERIFY(bench.coverage(1) == std::vector<std::uint8_t>(seen.size(), 0));
        QVERIFY(!bench.session->document().layer(1));
        QVERIFY(!bench.tried(drillInto(1)).isEmpty());
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QVERIFY(bench.session->document().layer(1));
        QVERIFY(bench.engine.carved().values == seen);
        bench.run(ChangeLayer{.layer = 2, .muted = true});
        QVERIFY(bench.tried(MergeLayers{.from = 1, .into = 2})
                    .contains(QStringLiteral("what is seen would change")));
        QVERIFY(!bench.tried(MergeLayers{.from = 1, .into = 1}).isEmpty());
        QVERIFY(!bench.tried(MergeLayers{.from = 1, .into = 9}).isEmpty());
        QVERIFY(!Bench({drillInto(1)}).tried(RemoveLayer{.layer = 1}).isEmpty()); // the only one
    }

    /// What waits in line behind a deletion meets a document without the layer.
    void theHastyAreRefused()
    {
        Bench bench({second});
        QVERIFY(bench.session->apply(RemoveLayer{.layer = 2}));
        QVERIFY(!bench.session->apply(MergeLayers{.from = 2, .into = 1}));
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.rows(), std::size_t(2));
    }

    /// Reading counts as touching: what was read cannot be taken back alone.
    void readingHolds()
    {
        const SegmentSeen seen{.target = toNew, .lower = 500.0};
        for (const Edit& reader : {Edit(LayerToSegment{.layer = 1, .target = toNew}), Edit(seen)}) {
            Bench bench({drillInto(1), reader});
            QVERIFY(!bench.tried(test::revertRows({1})).isEmpty());
        }
        Bench grown({test::addSegment("Brain"), test::seedInBrain(1), test::growBrain(2),
            SegmentToLayer{.segment = 1, .layer = 1}});
        QVERIFY(!grown.tried(test::revertRows({3})).isEmpty());
        const std::vector<std::uint8_t> empty(grown.coverage(1).size(), 0);
        QVERIFY(grown.coverage(1) != empty);
        grown.run(test::revertRows({4}));
        QVERIFY(grown.coverage(1) == empty);
    }

    /// A stroke cannot be worked out anew by its cuts alone where something else wrote its layer.
    void strokesBelowAreNotRevised()
    {
        const ReviseStroke wider{.row = 2, .radiusMm = 6.0};
        const std::vector<Edit> before{second, drillInto(1), test::addSegment("Brain"),
            test::seedInBrain(1), test::growBrain(2)};
        const auto with = [&before](const Edit& more) {
            std::vector<Edit> edits = before;
            edits.push_back(more);
            return edits;
        };
        QVERIFY(Bench(before).tried(wider).isEmpty());
        for (const Edit& writer : {Edit(SegmentToLayer{.segment = 1, .layer = 1}),
                 Edit(MergeLayers{.from = 2, .into = 1})}) {
            const QString why = Bench(with(writer)).tried(wider);
            QVERIFY2(why.contains(QStringLiteral("row 6")), qPrintable(why));
        }
        QVERIFY(!Bench(with(MergeLayers{.from = 1, .into = 2})).tried(wider).isEmpty());
        QVERIFY(!Bench(with(RemoveLayer{.layer = 1})).tried(wider).isEmpty());
        // Another layer is no hindrance, nor is what was taken back.
        QVERIFY(Bench(with(SegmentToLayer{.segment = 1, .layer = 2})).tried(wider).isEmpty());
        Bench back(with(SegmentToLayer{.segment = 1, .layer = 1}));
        back.run(test::revertRows({6}));
        QCOMPARE(back.tried(wider), QString());
    }
};

BURIN_TEST(LayerPassagesTest)

} // namespace layerPassagesTest

#include "LayerPassagesTest.moc"
