// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/PinholeOffer.h"

#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/workspace/SegmentActions.h"

#include <QAbstractButton>
#include <QtTest>

#include <cmath>
#include <vector>

namespace pinholeOfferUiTest {

using test::WorkspaceFixture;

namespace {

/// The small head, with air at some voxels of its ventricle.
/// @param tilted the slices are stacked 25° off their normal, as with a tilted gantry
core::LoadedVolume withAirAt(const std::vector<glm::ivec3>& voxels, bool tilted)
{
    core::LoadedVolume loaded = test::smallHead::volume();
    if (tilted) {
        glm::dmat4& indexToWorld = loaded.volume.geometry.indexToWorld;
        const glm::dvec3 middle = loaded.volume.geometry.toIndex(glm::dvec3(0.0));
        const double angle = 25.0 * 3.14159265358979323846 / 180.0;
        indexToWorld[2] =
            glm::length(indexToWorld[2]) * glm::dvec4(0.0, std::sin(angle), std::cos(angle), 0.0);
        indexToWorld[3] -= glm::dvec4(loaded.volume.geometry.toWorld(middle), 0.0);
    }
    constexpr auto side = std::size_t(test::smallHead::side);
    for (const glm::ivec3& voxel : voxels)
        loaded.codes[(std::size_t(voxel.z) * side + std::size_t(voxel.y)) * side
            + std::size_t(voxel.x)] = loaded.codes.front();
    return loaded;
}

/// Four voxels in three holes.
const std::vector<glm::ivec3> pinholes{{20, 20, 21}, {22, 20, 20}, {20, 22, 20}, {20, 23, 20}};

/// One hole that is too large to be a pinhole.
std::vector<glm::ivec3> cavity()
{
    std::vector<glm::ivec3> voxels;
    for (int y = 19; y <= 21; ++y) {
        for (int x = 19; x <= 21; ++x)
            voxels.emplace_back(x, y, 18);
    }
    return voxels;
}

class Grown : public WorkspaceFixture {
public:
    explicit Grown(const std::vector<glm::ivec3>& air, bool tilted = false)
        : WorkspaceFixture(withAirAt(air, tilted))
        , panel(workspace)
        , offer(*panel.findChild<ui::PinholeOffer*>())
    {
        panel.show();
        if (!ui::addSegment(workspace))
            qFatal("no segment");
        apply(middleSeed(1));
        ui::GrowSettings settings = workspace.growSettings();
        settings.guard.on = false;
        settings.lower = 0.0;
        settings.upper = 20.0;
        workspace.setGrowSettings(settings);
        grow();
    }
    void grow()
    {
        QTest::mouseClick(
            panel.findChild<QAbstractButton*>(QStringLiteral("growToClosure")), Qt::LeftButton);
        // To settle would end a growth that is under way.
        const bool over = QTest::qWaitFor([this] {
            session().poll();
            return !panel.running();
        });
        if (!over)
            qFatal("it grows on");
        wait();
    }
    /// For what is looked for, if anything is.
    void wait()
    {
        for (int i = 0; i < 20; ++i) {
            settle();
            QTest::qWait(10);
        }
    }
    [[nodiscard]] std::int64_t voxels() { return session().document().segment(1)->voxels; }
    [[nodiscard]] std::size_t rows() { return session().history().rows().size(); }

    ui::GrowthPanel panel;
    ui::PinholeOffer& offer;
};

} // namespace

class PinholeOfferUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void nothingIsOfferedWithoutPinholes()
    {
        Grown whole({});
        QVERIFY(whole.offer.isHidden());
        Grown hollow(cavity());
        QVERIFY(hollow.offer.isHidden());
    }

    void oneClickIsOneRow()
    {
        std::vector<glm::ivec3> air = cavity();
        air.insert(air.end(), pinholes.begin(), pinholes.end());
        Grown fixture(air);
        QVERIFY(QTest::qWaitFor([&] {
            fixture.settle();
            return !fixture.offer.isHidden();
        }));
        QVERIFY2(
            fixture.offer.text().startsWith(QStringLiteral("4 voxels inside 'Segment 1' were")),
            qPrintable(fixture.offer.text()));
        const QByteArray before = fixture.session().stateHash();
        const std::int64_t voxels = fixture.voxels();
        const std::size_t rows = fixture.rows();
        Q_EMIT fixture.offer.linkActivated(QStringLiteral("fill"));
        QVERIFY(fixture.offer.isHidden());
        fixture.settle();
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.session().history().rows().back().edit.is<core::CleanSegment>());
        QCOMPARE(fixture.voxels(), voxels + 4);
        // All that the growth would have taken without them.
        QCOMPARE(fixture.voxels() + 9, test::smallHead::voxelsOf(test::smallHead::ventricleHu));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.session().stateHash(), before);
        Q_EMIT fixture.offer.linkActivated(QStringLiteral("fill")); // it was withdrawn
        fixture.settle();
        QCOMPARE(fixture.session().stateHash(), before);
    }

    /// Of a sheared grid, too, all is filled that was offered.
    void aTiltedScanHasItsPinholesFilled()
    {
        std::vector<glm::ivec3> hole; // as large as a pinhole may be
        for (int i = 0; i < ui::PinholeOffer::mostVoxels; ++i)
            hole.emplace_back(21 + (i & 1), 19 + (i >> 1 & 1), 20 + (i >> 2));
        Grown fixture(hole, true);
        QVERIFY(QTest::qWaitFor([&] {
            fixture.settle();
            return !fixture.offer.isHidden();
        }));
        const std::int64_t voxels = fixture.voxels();
        Q_EMIT fixture.offer.linkActivated(QStringLiteral("fill"));
        fixture.settle();
        QCOMPARE(fixture.voxels(), voxels + 8);
    }

    /// It is about what has just grown, and nothing else.
    void theNextStepWithdrawsIt()
    {
        Grown fixture(pinholes);
        QVERIFY(QTest::qWaitFor([&] {
            fixture.settle();
            return !fixture.offer.isHidden();
        }));
        fixture.apply(test::lockSegment(1));
        QVERIFY(fixture.offer.isHidden());
        fixture.offer.lookInto(1); // nobody may fill it
        fixture.wait();
        QVERIFY(fixture.offer.isHidden());
        fixture.apply(test::lockSegment(1, false));
        fixture.offer.lookInto(1);
        QVERIFY(QTest::qWaitFor([&] {
            fixture.settle();
            return !fixture.offer.isHidden();
        }));
        QVERIFY(fixture.session().undo());
        fixture.wait();
        QVERIFY(fixture.offer.isHidden());
    }

    /// What is another segment's stays so, and is no reason to ask.
    void othersAreLeftAlone()
    {
        Grown fixture({{22, 20, 20}});
        QVERIFY(QTest::qWaitFor([&] {
            fixture.settle();
            return !fixture.offer.isHidden();
        }));
        QVERIFY(fixture.offer.text().startsWith(QStringLiteral("One voxel")));
        fixture.apply(test::newSegment(QStringLiteral("Stone"), 1));
        fixture.apply(test::paintAt(2, {{2.0, 0.0, 0.0}}, 0.4));
        QCOMPARE(fixture.session().document().segment(2)->voxels, std::int64_t(1));
        fixture.offer.lookInto(1);
        fixture.wait();
        QVERIFY(fixture.offer.isHidden());
    }
};

BURIN_WINDOW_TEST(PinholeOfferUiTest)

} // namespace pinholeOfferUiTest

#include "PinholeOfferUiTest.moc"
