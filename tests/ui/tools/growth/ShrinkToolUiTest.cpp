// SPDX-License-Identifier: Apache-2.0
#include "core/session/questions/VoxelQuestions.h"
#include "ui/tools/growth/ShrinkTool.h"

#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "tests/support/cases/growth/LeakPhantoms.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/NumberText.h"
#include "ui/tools/growth/HeldShrink.h"
#include "ui/tools/growth/ShrinkPreview.h"
#include "ui/views/ViewGrid.h"

#include <QToolButton>
#include <QtTest>

#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

namespace shrinkToolUiTest {

namespace {

const test::LeakPhantom& phantom()
{
    static const test::LeakPhantom made = test::leakPhantom(0, true);
    return made;
}

/// The real window with a vessel that has grown to closure through a hole in its wall; the
/// crosshair stands in the leak, and the 3D view looks at it.
class ShrinkFixture : public test::WindowFixture {
public:
    ShrinkFixture()
        : test::WindowFixture(test::loadedVolume(phantom()))
        , tool(workspace)
        , slice(window.views().axial())
        , view(window.views().volume())
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = phantom().lowCode;
        workspace.setVolumeDisplay(display);
        workspace.setActiveTool(&tool);
        apply(test::newSegment(QStringLiteral("Vessel"), 1));
        apply(test::seedAt(1, {placeOf(phantom().seed)}));
        grow();
        workspace.setCrosshairLps(placeOf(phantom().click));
        view.lookFrom({0.0, 1.0, 0.0}); // the leak is on the vessel's back
    }
    [[nodiscard]] glm::dvec3 placeOf(const glm::ivec3& voxel) const
    {
        return workspace.volume()->geometry.toWorld(glm::dvec3(voxel));
    }
    void apply(const core::Edit& edit)
    {
        if (!session().apply(edit) || !session().settle())
            qFatal("an edit was refused");
    }
    void grow(int wider = 0)
    {
        apply(test::growBetween(phantom().lowCode - wider, phantom().highCode + wider));
    }
    /// Over a voxel of the leak, as it is seen in a view.
    void sketch(ui::ImageView& where, const QPointF& offset = {})
    {
        const QPointF at = where.context().toPixel(placeOf(phantom().click)) + offset;
        test::Pen pen(where);
        pen.press(at - QPointF(6, 0), 0.5, 100);
        pen.move(at, 0.5, 108);
        pen.move(at + QPointF(6, 0), 0.5, 116);
        pen.release(at + QPointF(6, 0), 124);
        answered();
    }
    /// Takes in what was seen, then what became of the edit.
    void answered()
    {
        session().poll();
        const auto settled = session().settle();
        if (!settled && settled.error().code != core::ErrorCode::NothingGrown)
            qFatal("the sketch failed");
        session().poll();
    }
    [[nodiscard]] const core::ShrinkAt* lastShrink()
    {
        const core::History& history = session().history();
        return history.row(history.position()).edit.as<core::ShrinkAt>();
    }
    [[nodiscard]] std::vector<std::uint8_t> labels() { return *session().questions().labels(0); }
    struct Held {
        std::int64_t leak = 0;
        std::int64_t body = 0;
    };
    [[nodiscard]] Held held()
    {
        const auto now = labels();
        Held found;
        for (std::size_t voxel = 0; voxel < now.size(); ++voxel)
            if (now[voxel] != 0)
                ++(phantom().leak.values[voxel] ? found.leak : found.body);
        return found;
    }

    ui::ShrinkTool tool;
    ui::SliceView& slice;
    ui::VolumeView& view;
};

} // namespace

class ShrinkToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aSketchOverTheLeakTakesItBackAndShutsIt_data()
    {
        QTest::addColumn<bool>("inVolume");
        QTest::newRow("slice") << false;
        QTest::newRow("3D") << true;
    }
    void aSketchOverTheLeakTakesItBackAndShutsIt()
    {
        QFETCH(bool, inVolume);
        ShrinkFixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const auto before = fixture.held();
        QVERIFY(before.leak > 10000 && before.body > 1000);
        const std::size_t rows = fixture.rows();
        const QByteArray leaked = fixture.session().stateHash();

        fixture.sketch(inVolume ? static_cast<ui::ImageView&>(fixture.view) : fixture.slice);
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastShrink());
        QVERIFY(!fixture.lastShrink()->onlyHere && fixture.lastShrink()->barrier);
        const auto after = fixture.held();
        QCOMPARE(after.leak, std::int64_t(0));
        QVERIFY2(after.body * 10 > before.body * 9,
            qPrintable(QStringLiteral("%1 of %2").arg(after.body).arg(before.body)));
        QVERIFY(!said.isEmpty());
        QVERIFY2(said.back()[0].toString().startsWith(QStringLiteral("Shrink here")),
            qPrintable(said.back()[0].toString()));

        // It stays shut, for a wider interval too.
        fixture.grow();
        QCOMPARE(fixture.held().leak, std::int64_t(0));
        fixture.grow(100);
        QCOMPARE(fixture.held().leak, std::int64_t(0));
        while (fixture.rows() > 0 && !fixture.lastShrink())
            QVERIFY(fixture.session().undo() && fixture.session().settle());
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), leaked);
    }

    void controlTakesTheSketchedVoxelsAlone()
    {
        ShrinkFixture fixture;
        const auto before = fixture.labels();
        const std::size_t rows = fixture.rows();
        const QByteArray leaked = fixture.session().stateHash();
        const QPoint at =
            fixture.slice.context().toPixel(fixture.placeOf(phantom().click)).toPoint();
        QTest::mousePress(&fixture.slice, Qt::LeftButton, Qt::ControlModifier, at);
        QTest::mouseMove(&fixture.slice, at + QPoint(10, 4));
        QTest::mouseRelease(
            &fixture.slice, Qt::LeftButton, Qt::ControlModifier, at + QPoint(20, 8));
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastShrink() && fixture.lastShrink()->onlyHere);
        std::set<std::size_t> sketched;
        const glm::ivec3 size = phantom().leak.size;
        for (const glm::dvec3& point : fixture.lastShrink()->pointsLps) {
            const glm::ivec3 voxel(glm::round(fixture.workspace.volume()->geometry.toIndex(point)));
            sketched.insert(std::size_t(voxel.x + size.x * (voxel.y + size.y * voxel.z)));
        }
        QVERIFY(sketched.size() > 2);
        const auto after = fixture.labels();
        for (std::size_t voxel = 0; voxel < after.size(); ++voxel)
            QCOMPARE(int(after[voxel]), sketched.count(voxel) > 0 ? 0 : int(before[voxel]));
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), leaked);
    }

    /// A pen sketches as wide as it is pressed, if that is switched on, and the preview counts all
    /// of it; with the eraser end the sketched voxels alone are taken.
    void pressureIsTheWidth_data()
    {
        QTest::addColumn<bool>("inVolume");
        QTest::newRow("slice") << false;
        QTest::newRow("3D") << true;
    }
    void pressureIsTheWidth()
    {
        QFETCH(const bool, inVolume);
        ShrinkFixture fixture;
        ui::ImageView& where = inVolume ? static_cast<ui::ImageView&>(fixture.view) : fixture.slice;
        const QByteArray leaked = fixture.session().stateHash();
        auto* button = fixture.window.findChild<QToolButton*>(QStringLiteral("radiusByPressure"));
        QVERIFY(button && !button->isChecked());
        const QPointF at = where.context().toPixel(fixture.placeOf(phantom().click));
        const auto taken = [&](double pressure) {
            const std::size_t rows = fixture.rows();
            test::Pen pen(where, test::Pen::End::Eraser);
            pen.press(at - QPointF(6, 0), pressure, 100);
            pen.move(at + QPointF(6, 0), pressure, 108);
            const auto answered = [&] {
                fixture.session().poll();
                return fixture.tool.previewIsWhole();
            };
            if (!QTest::qWaitFor(answered, 60000))
                return std::int64_t(-1);
            const std::int64_t foreseen = fixture.tool.preview().voxels().value_or(0);
            pen.release(at + QPointF(6, 0), 116);
            fixture.answered();
            const core::ShrinkAt* shrink = fixture.lastShrink();
            const bool isAsForeseen = fixture.rows() == rows + 1 && shrink && shrink->onlyHere
                && fixture.session().history().rows().back().statistics.voxelsChanged == foreseen;
            const bool isBack = fixture.session().undo() && fixture.session().settle()
                && fixture.session().stateHash() == leaked;
            return isAsForeseen && isBack ? foreseen : std::int64_t(-1);
        };
        const std::int64_t line = taken(1.0);
        QVERIFY2(line > 0, qPrintable(QString::number(line)));
        button->click();
        QVERIFY(fixture.tool.settingsJson()[QStringLiteral("byPressure")].toBool());
        const std::int64_t light = taken(0.5);
        const std::int64_t firm = taken(1.0);
        QVERIFY2(light > line && firm > light,
            qPrintable(QStringLiteral("%1, %2, %3").arg(line).arg(light).arg(firm)));
        ui::ShrinkTool other(fixture.workspace);
        other.applySettings(fixture.tool.settingsJson());
        QCOMPARE(other.settingsJson(), fixture.tool.settingsJson());
        // A mouse draws a line.
        const std::size_t rows = fixture.rows();
        test::drawStroke(test::DrawnBy::Mouse, where, {at - QPointF(6, 0), at + QPointF(6, 0)},
            Qt::ControlModifier);
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.session().history().rows().back().statistics.voxelsChanged, line);
    }

    void whereNothingGrewThatIsSaid()
    {
        ShrinkFixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        std::vector<core::Error> failures;
        connect(&fixture.workspace, &ui::Workspace::failed, this,
            [&failures](const core::Error& error) { failures.push_back(error); });
        const std::size_t rows = fixture.rows();
        const QByteArray leaked = fixture.session().stateHash();
        // In a corner of the volume, where nothing is.
        fixture.workspace.setCrosshairLps(fixture.placeOf({2, 93, 2}));
        const QPointF corner = fixture.slice.context().toPixel(fixture.placeOf({2, 93, 2}));
        fixture.sketch(fixture.slice,
            corner - fixture.slice.context().toPixel(fixture.placeOf(phantom().click)));
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.session().stateHash(), leaked);
        QCOMPARE(said.count(), 0);
        QCOMPARE(failures.size(), std::size_t(1));
        QCOMPARE(failures[0].code, core::ErrorCode::NothingGrown);
        // Beside what is seen, in 3D.
        fixture.sketch(fixture.view,
            QPointF(0.5 * fixture.view.width() - 20.0, 0.0)
                - (fixture.view.context().toPixel(fixture.placeOf(phantom().click))
                    - QPointF(fixture.view.width(), fixture.view.height()) / 2.0));
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(said.count(), 1);
        QVERIFY(said[0][0].toString().startsWith(QStringLiteral("Nothing was taken back")));
    }

    /// Seeds are never taken back: it is foreseen, and then told, why.
    void overSeedsItIsRefused()
    {
        ShrinkFixture fixture;
        std::vector<core::Error> failures;
        connect(&fixture.workspace, &ui::Workspace::failed, this,
            [&failures](const core::Error& error) { failures.push_back(error); });
        const std::size_t rows = fixture.rows();
        const QByteArray leaked = fixture.session().stateHash();
        fixture.workspace.setCrosshairLps(fixture.placeOf(phantom().seed));
        const QPoint at =
            fixture.slice.context().toPixel(fixture.placeOf(phantom().seed)).toPoint();
        QTest::mousePress(&fixture.slice, Qt::LeftButton, Qt::NoModifier, at);
        QTRY_VERIFY((fixture.session().poll(), fixture.tool.previewIsWhole()));
        QCOMPARE(fixture.tool.preview().words(),
            QStringLiteral("takes nothing: there are seeds under the sketch"));
        QTest::mouseRelease(&fixture.slice, Qt::LeftButton, Qt::NoModifier, at);
        fixture.session().poll();
        QVERIFY(!fixture.session().settle());
        fixture.session().poll();
        QCOMPARE(failures.size(), std::size_t(1));
        QCOMPARE(failures[0].code, core::ErrorCode::SeedsStay);
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.session().stateHash(), leaked);
    }

    void beforePenUpItTellsWhatItTakes_data()
    {
        QTest::addColumn<bool>("inVolume");
        QTest::addColumn<bool>("onlyHere");
        QTest::newRow("slice") << false << false;
        QTest::newRow("3D") << true << false;
        QTest::newRow("slice, only here") << false << true;
        QTest::newRow("3D, only here") << true << true;
    }
    void beforePenUpItTellsWhatItTakes()
    {
        QFETCH(bool, inVolume);
        QFETCH(bool, onlyHere);
        ShrinkFixture fixture;
        ui::ImageView& where = inVolume ? static_cast<ui::ImageView&>(fixture.view) : fixture.slice;
        const ui::ShrinkPreview& preview = fixture.tool.preview();
        const std::size_t rows = fixture.rows();
        const QByteArray leaked = fixture.session().stateHash();
        const auto before = fixture.labels();
        const QPoint at = where.context().toPixel(fixture.placeOf(phantom().click)).toPoint();
        const Qt::KeyboardModifiers keys = onlyHere ? Qt::ControlModifier : Qt::NoModifier;
        const auto sketch = [&] {
            QTest::mousePress(&where, Qt::LeftButton, keys, at);
            QTest::mouseMove(&where, at + QPoint(3, 1));
            QTest::mouseMove(&where, at + QPoint(6, 2));
            const auto answered = [&] {
                fixture.session().poll();
                return fixture.tool.previewIsWhole();
            };
            return QTest::qWaitFor(answered, 60000);
        };
        QVERIFY(preview.words().isEmpty());
        QVERIFY(sketch());
        const std::int64_t voxels = preview.voxels().value_or(0);
        QVERIFY(onlyHere ? voxels > 0 && voxels < 100 : voxels > 10000);
        const QString volume =
            ui::millilitreText(voxels, fixture.workspace.volume()->geometry.voxelVolumeMm3());
        QCOMPARE(preview.words(),
            onlyHere ? QStringLiteral("takes only this: %1").arg(volume)
                     : QStringLiteral("takes %1").arg(volume));
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.session().stateHash(), leaked);
        QCOMPARE(fixture.labels(), before);

        QTest::keyClick(&where, Qt::Key_Escape);
        QTest::mouseRelease(&where, Qt::LeftButton, keys, at + QPoint(6, 2));
        fixture.answered();
        QVERIFY(preview.words().isEmpty() && !preview.voxels());
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.session().stateHash(), leaked);

        QVERIFY(sketch());
        QCOMPARE(preview.voxels().value_or(0), voxels);
        QTest::mouseRelease(&where, Qt::LeftButton, keys, at + QPoint(6, 2));
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastShrink() && fixture.lastShrink()->onlyHere == onlyHere);
        QCOMPARE(fixture.session().history().rows().back().statistics.voxelsChanged, voxels);
        QVERIFY(preview.words().isEmpty());
    }

    /// The pen sketches and is held still: the growth goes back under it, and lifting it makes one
    /// row.
    void heldItGoesBackGenerationByGeneration_data()
    {
        QTest::addColumn<bool>("inVolume");
        QTest::newRow("slice") << false;
        QTest::newRow("3D") << true;
    }
    void heldItGoesBackGenerationByGeneration()
    {
        QFETCH(bool, inVolume);
        ShrinkFixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        ui::ImageView& where = inVolume ? static_cast<ui::ImageView&>(fixture.view) : fixture.slice;
        const std::size_t rows = fixture.rows();
        const QByteArray leaked = fixture.session().stateHash();
        const auto before = fixture.held();
        const QPoint at = where.context().toPixel(fixture.placeOf(phantom().click)).toPoint();
        const auto stepsDone = [&] {
            fixture.session().poll();
            const auto progress = fixture.session().growthProgress().backwards;
            return progress ? int(progress->steps) : 0;
        };
        const auto hold = [&] {
            QTest::mousePress(&where, Qt::LeftButton, Qt::NoModifier, at);
            QTest::mouseMove(&where, at + QPoint(3, 1));
            QTest::mouseMove(&where, at + QPoint(4, 1));
            return QTest::qWaitFor([&] { return stepsDone() >= 1; }, 60000);
        };
        QVERIFY(hold());
        QVERIFY(fixture.tool.held().on());
        QVERIFY(fixture.tool.preview().words().isEmpty());
        const auto first = fixture.held();
        QVERIFY(first.leak < before.leak);
        QCOMPARE(fixture.rows(), rows);
        const int steps = inVolume ? 1 : 3; // the oracle takes its time
        QVERIFY(QTest::qWaitFor([&] { return stepsDone() >= steps; }, 60000));
        QVERIFY(fixture.tool.held().words().contains(QStringLiteral(" back: takes ")));
        QVERIFY(inVolume || fixture.held().leak < first.leak);
        QCOMPARE(fixture.rows(), rows);
        // A hand that trembles, or moves on, changes nothing.
        QTest::mouseMove(&where, at + QPoint(14, 6));
        QTest::mouseRelease(&where, Qt::LeftButton, Qt::NoModifier, at + QPoint(14, 6));
        fixture.answered();
        QVERIFY(!fixture.tool.held().on());
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastShrink() && fixture.lastShrink()->steps.value_or(0) >= steps);
        QVERIFY(!fixture.lastShrink()->onlyHere);
        QVERIFY2(said.back()[0].toString().startsWith(QStringLiteral("Shrink here ")),
            qPrintable(said.back()[0].toString()));
        const QByteArray shrunk = fixture.session().stateHash();
        QVERIFY(shrunk != leaked);
        const core::ShrinkAt done = *fixture.lastShrink();
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), leaked);
        if (inVolume)
            return;
        // The same at once.
        fixture.apply(done);
        QCOMPARE(fixture.session().stateHash(), shrunk);
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        const std::size_t rowsThen = fixture.rows();

        QVERIFY(hold());
        QTest::keyClick(&where, Qt::Key_Escape);
        QTest::mouseRelease(&where, Qt::LeftButton, Qt::NoModifier, at);
        fixture.answered();
        QCOMPARE(fixture.rows(), rowsThen);
        QCOMPARE(fixture.session().stateHash(), leaked);
    }

    /// Another edit ends the held one as a step; what the pen does then is not that edit's end.
    void anotherEditIsNotTakenForTheHeldOne()
    {
        ShrinkFixture fixture;
        const std::size_t rows = fixture.rows();
        const QPoint at =
            fixture.slice.context().toPixel(fixture.placeOf(phantom().click)).toPoint();
        QTest::mousePress(&fixture.slice, Qt::LeftButton, Qt::NoModifier, at);
        QTest::mouseMove(&fixture.slice, at + QPoint(3, 1));
        QVERIFY(QTest::qWaitFor(
            [&] {
                fixture.session().poll();
                return fixture.session().growthProgress().backwards.has_value();
            },
            60000));
        QVERIFY(fixture.session().isOpen<core::ShrinkAt>());
        QVERIFY(!fixture.tool.held().refused());
        QVERIFY(fixture.session().begin(test::growBetween(phantom().lowCode, phantom().highCode)));
        QVERIFY(!fixture.session().isOpen<core::ShrinkAt>());
        QVERIFY(fixture.session().transactionOpen());
        QTest::keyClick(&fixture.slice, Qt::Key_Escape);
        QVERIFY(fixture.session().transactionOpen());
        QTest::mouseRelease(&fixture.slice, Qt::LeftButton, Qt::NoModifier, at);
        QVERIFY(fixture.session().transactionOpen());
        fixture.session().end(core::Ending::Commit);
        fixture.answered();
        // The other one had nothing left to grow.
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastShrink());
    }

    /// Beside the seed, going back would take all that has grown: it is refused, and lifting the
    /// pen cuts off what was sketched, as without the rest.
    void aRefusedHoldLeavesThePlainCut()
    {
        ShrinkFixture fixture;
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        const glm::ivec3 seed = phantom().seed;
        core::GrowCriteria line{
            .lower = double(phantom().lowCode), .upper = double(phantom().highCode)};
        line.box =
            core::GrowBox{fixture.placeOf(seed), fixture.placeOf(seed + glm::ivec3(3, 0, 0))};
        fixture.apply(test::growBy(line));
        QCOMPARE(fixture.held().body, std::int64_t(4));
        fixture.workspace.setCrosshairLps(fixture.placeOf(seed));
        const std::size_t rows = fixture.rows();
        const QPoint at =
            fixture.slice.context().toPixel(fixture.placeOf(seed + glm::ivec3(1, 0, 0))).toPoint();
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        QTest::mousePress(&fixture.slice, Qt::LeftButton, Qt::NoModifier, at);
        QVERIFY(QTest::qWaitFor(
            [&] {
                fixture.session().poll();
                return fixture.tool.held().refused();
            },
            60000));
        QCOMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].value<core::Error>().code == core::ErrorCode::EverythingGrown);
        QTest::mouseRelease(&fixture.slice, Qt::LeftButton, Qt::NoModifier, at);
        fixture.session().poll();
        const auto settled = fixture.session().settle();
        QVERIFY(settled || settled.error().code == core::ErrorCode::EverythingGrown); // of the hold
        QVERIFY(!fixture.tool.held().on());
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastShrink() && !fixture.lastShrink()->steps);
        QCOMPARE(fixture.held().body, std::int64_t(1));
    }

    void whereNothingGrewTheCursorSaysSo()
    {
        ShrinkFixture fixture;
        fixture.workspace.setCrosshairLps(fixture.placeOf({2, 93, 2}));
        const QPoint at = fixture.slice.context().toPixel(fixture.placeOf({2, 93, 2})).toPoint();
        QTest::mousePress(&fixture.slice, Qt::LeftButton, Qt::NoModifier, at);
        QTRY_VERIFY((fixture.session().poll(), fixture.tool.previewIsWhole()));
        QCOMPARE(fixture.tool.preview().words(), QStringLiteral("nothing grown here"));
        QTest::keyClick(&fixture.slice, Qt::Key_Escape);
        QTest::mouseRelease(&fixture.slice, Qt::LeftButton, Qt::NoModifier, at);
    }

    void escapeDropsTheSketch()
    {
        ShrinkFixture fixture;
        const std::size_t rows = fixture.rows();
        const QPointF at = fixture.slice.context().toPixel(fixture.placeOf(phantom().click));
        test::Pen pen(fixture.slice);
        pen.press(at, 0.5, 1);
        pen.move(at + QPointF(9, 0), 0.5, 2);
        QTest::keyClick(&fixture.slice, Qt::Key_Escape);
        pen.release(at + QPointF(9, 0), 3);
        fixture.answered();
        QCOMPARE(fixture.rows(), rows);
    }
};

BURIN_WINDOW_TEST(ShrinkToolUiTest)

} // namespace shrinkToolUiTest

#include "ShrinkToolUiTest.moc"
