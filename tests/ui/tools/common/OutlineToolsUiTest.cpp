// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/tools/sculpt/PeelTool.h"
#include "ui/tools/sculpt/ScissorsTool.h"
#include "ui/views/ViewGrid.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <vector>

namespace outlineToolsUiTest {

namespace {

/// The real window with the small head and both tools.
class OutlineFixture : public test::WindowFixture {
public:
    OutlineFixture()
        : test::WindowFixture(test::smallHead::volume())
        , peel(workspace)
        , scissors(workspace)
        , view(window.views().volume())
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setActiveTool(&peel);
        peel.setDepthMm(4.0);
        view.lookFrom({0.0, -1.0, 0.0});
    }
    [[nodiscard]] QPointF middle() const { return QPointF(view.width(), view.height()) / 2.0; }

    /// An open ring around the middle, or a place beside it: it closes by itself.
    void draw(
        double radiusPixels, test::Pen::End end = test::Pen::End::Tip, const QPointF& beside = {})
    {
        test::Pen pen(view, end);
        const auto at = [&](int i) {
            const double t = 2.0 * M_PI * i / 40.0;
            return middle() + beside + radiusPixels * QPointF(std::cos(t), std::sin(t));
        };
        pen.press(at(0), 0.5, ++m_milliseconds);
        for (int i = 1; i < 38; ++i)
            pen.move(at(i), 0.5, m_milliseconds += 8);
        pen.release(at(38), m_milliseconds += 8);
    }

    /// A drag that is not ended.
    void pull(test::Pen& pen, const std::vector<double>& down)
    {
        pen.press(middle(), 0.5, ++m_milliseconds);
        for (const double pixels : down)
            pen.move(middle() + QPointF(0.0, pixels), 0.5, m_milliseconds += 8);
    }
    void lift(test::Pen& pen, double down)
    {
        pen.release(middle() + QPointF(0.0, down), ++m_milliseconds);
    }
    void click()
    {
        test::Pen pen(view);
        pull(pen, {});
        lift(pen, 0.0);
    }
    [[nodiscard]] double mmPerPixel() const
    {
        return std::min(view.context().mmPerPixel(), ui::PeelTool::mostMmPerPixel);
    }

    ui::PeelTool peel;
    ui::ScissorsTool scissors;
    ui::VolumeView& view;

private:
    quint64 m_milliseconds = 90000;
};

} // namespace

class OutlineToolsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aPeelGoesBothWaysUntilItIsKept()
    {
        OutlineFixture fixture;
        fixture.draw(60.0);
        QVERIFY(fixture.peel.isOpen());
        QCOMPARE(fixture.rows(), std::size_t(0));
        const std::int64_t four = fixture.carvedVoxels();
        QVERIFY(four > 50);
        fixture.peel.changeDepth(4); // Ctrl + Shift + wheel
        QCOMPARE(fixture.peel.depthMm(), 6.0);
        QVERIFY(fixture.carvedVoxels() > four);
        fixture.peel.setDepthMm(4.0);
        QCOMPARE(fixture.carvedVoxels(), four);
        fixture.peel.setDepthMm(2.0);
        QVERIFY(fixture.carvedVoxels() < four);

        fixture.peel.confirm();
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.peel.isOpen());
        QCOMPARE(fixture.rows(), std::size_t(1));
        const auto& edit = fixture.session().history().rows().back().edit.get<core::PeelCut>();
        QCOMPARE(edit.depthMm, 2.0);
        QVERIFY(!edit.restore);
        QVERIFY(edit.polygonMm.size() > 30);
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.carvedVoxels(), std::int64_t(0));
    }

    /// What stands open since a preview has ended a peel is a dialog's.
    void aPeelEndsNoPreview_data()
    {
        QTest::addColumn<bool>("isKept");
        QTest::newRow("kept") << true;
        QTest::newRow("taken back") << false;
    }
    void aPeelEndsNoPreview()
    {
        QFETCH(const bool, isKept);
        OutlineFixture fixture;
        fixture.apply(test::newSegment(QStringLiteral("Organ")));
        fixture.apply(test::paintAt(1, {glm::dvec3(0.0)}, 3.0));
        fixture.draw(60.0);
        QVERIFY(fixture.peel.isOpen());
        QVERIFY(fixture.session().begin(core::ReshapeSegment{
            .segment = 1, .operation = core::ShapeOperation::Grow, .mm = 2.0}));
        if (isKept)
            fixture.peel.confirm();
        else
            fixture.peel.cancel();
        QVERIFY(!fixture.peel.isOpen());
        QVERIFY(fixture.session().openIsPreview());
        fixture.session().end(core::Ending::Rollback);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.session().history().rows().back().edit.is<core::PeelCut>());
    }

    /// Seed A §4.4: "adjusting a slider or dragging a pen on the tablet".
    void aSecondDragSetsTheDepthBothWays()
    {
        OutlineFixture fixture;
        fixture.draw(60.0);
        const std::int64_t four = fixture.carvedVoxels();
        const double pixels = 3.0 / fixture.mmPerPixel(); // of 3 mm
        test::Pen pen(fixture.view);
        fixture.pull(pen, {pixels / 2.0, pixels});
        QCOMPARE(fixture.peel.depthMm(), 7.0);
        const std::int64_t seven = fixture.carvedVoxels();
        QVERIFY(seven > four);
        QTest::mouseMove(&fixture.view); // nothing of the mouse disturbs the pen
        pen.move(fixture.middle() - QPointF(0.0, pixels), 0.5, 99000);
        QCOMPARE(fixture.peel.depthMm(), 1.0);
        QVERIFY(fixture.carvedVoxels() < four);
        pen.move(fixture.middle() - QPointF(0.0, 100.0 * pixels), 0.5, 99010);
        QCOMPARE(fixture.peel.depthMm(), ui::PeelTool::minimumDepthMm);
        pen.move(fixture.middle() + QPointF(0.0, pixels), 0.5, 99020);
        QCOMPARE(fixture.carvedVoxels(), seven);
        QVERIFY(fixture.peel.isOpen());
        QCOMPARE(fixture.rows(), std::size_t(0));

        fixture.lift(pen, pixels);
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.peel.isOpen());
        QCOMPARE(fixture.rows(), std::size_t(1));
        QCOMPARE(fixture.session().history().rows().back().edit.get<core::PeelCut>().depthMm, 7.0);
        QCOMPARE(fixture.carvedVoxels(), seven);
        fixture.draw(40.0); // the next drag is a curve again
        QVERIFY(fixture.peel.isOpen());
    }

    void theMouseAndKeysSetItToo()
    {
        OutlineFixture fixture;
        fixture.draw(60.0);
        fixture.peel.changeRadius(2); // ]
        QCOMPARE(fixture.peel.depthMm(), 5.0);
        fixture.peel.changeRadius(-4); // [
        QCOMPARE(fixture.peel.depthMm(), 3.0);
        const QPoint middle = fixture.middle().toPoint();
        const int pixels = int(std::lround(2.0 / fixture.mmPerPixel()));
        QTest::mousePress(&fixture.view, Qt::LeftButton, {}, middle);
        QTest::mouseMove(&fixture.view, middle + QPoint(0, pixels));
        QVERIFY(std::abs(fixture.peel.depthMm() - 5.0) < 0.11);
        QVERIFY(fixture.peel.isOpen());
        QTest::mouseRelease(&fixture.view, Qt::LeftButton, {}, middle + QPoint(0, pixels));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(1));
    }

    void escapeTakesItBackDuringTheDrag()
    {
        OutlineFixture fixture;
        fixture.draw(60.0);
        test::Pen pen(fixture.view);
        fixture.pull(pen, {10.0, 20.0});
        QTest::keyClick(&fixture.view, Qt::Key_Escape);
        QVERIFY(!fixture.peel.isOpen());
        fixture.lift(pen, 25.0);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.carvedVoxels(), std::int64_t(0));
        QCOMPARE(fixture.rows(), std::size_t(0));
        fixture.draw(60.0);
        QVERIFY(fixture.peel.isOpen());
    }

    void anotherToolTellsThatItIsKept()
    {
        OutlineFixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        std::vector<ui::Workspace::Offer> offers;
        connect(&fixture.workspace, &ui::Workspace::offered, this,
            [&offers](const ui::Workspace::Offer& made) { offers.push_back(made); });
        fixture.draw(60.0);
        fixture.workspace.setActiveTool(&fixture.scissors);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(1));
        QCOMPARE(offers.size(), std::size_t(1));
        QVERIFY(offers.front().sentence.contains(QStringLiteral("kept")));
        QVERIFY(said.back().front().toString().contains(QStringLiteral("kept")));
        QVERIFY(fixture.carvedVoxels() > 0);
        offers.front().run();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.carvedVoxels(), std::int64_t(0));
        offers.front().run(); // it is not the last step any more
        QVERIFY(fixture.session().settle());
        QVERIFY(said.back().front().toString().contains(QStringLiteral("gone on")));

        // What was kept on purpose, and what undo takes back, needs no word.
        fixture.workspace.setActiveTool(&fixture.peel);
        fixture.draw(60.0);
        fixture.click();
        fixture.draw(30.0);
        fixture.window.actionTable()[QStringLiteral("edit.undo")].trigger();
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.peel.isOpen());
        QCoreApplication::processEvents();
        fixture.workspace.setActiveTool(&fixture.scissors);
        QCOMPARE(offers.size(), std::size_t(1));
    }

    /// A peel over the air is no step, and nothing is said or offered as if it were.
    void whereNothingIsPeeledThatIsSaid()
    {
        OutlineFixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QSignalSpy offered(&fixture.workspace, &ui::Workspace::offered);
        const auto last = [&said] { return said.back().front().toString(); };
        const double perMm = 1.0 / fixture.view.context().mmPerPixel();
        const QPointF air(21.0 * perMm, 0.0);
        fixture.draw(3.0 * perMm, test::Pen::End::Tip, air);
        QVERIFY(fixture.peel.isOpen());
        fixture.peel.confirm();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(0));
        QTRY_COMPARE(last(), QStringLiteral("Nothing was peeled there"));
        fixture.draw(3.0 * perMm, test::Pen::End::Tip, air);
        fixture.workspace.setActiveTool(&fixture.scissors);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(0));
        QTRY_COMPARE(last(), QStringLiteral("Nothing was peeled there"));
        QVERIFY(offered.isEmpty());
        // What is peeled can be lifted; what is restored cannot.
        fixture.workspace.setActiveTool(&fixture.peel);
        fixture.draw(60.0);
        fixture.peel.confirm();
        QVERIFY(fixture.session().settle());
        QVERIFY2(last().startsWith(QStringLiteral("Peel 4.0 mm"))
                && last().endsWith(QStringLiteral("Ctrl+L lifts it as a piece")),
            qPrintable(last()));
        fixture.draw(60.0, test::Pen::End::Eraser);
        fixture.peel.confirm();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2));
        QVERIFY2(last().startsWith(QStringLiteral("Restore peel"))
                && !last().contains(QStringLiteral("Ctrl+L")),
            qPrintable(last()));
    }

    void gapsCanBeSetWhileItIsOpen()
    {
        OutlineFixture fixture;
        QWidget bar;
        const std::unique_ptr<QWidget> options(fixture.peel.createOptions(&bar));
        auto* through = options->findChild<QCheckBox*>(QStringLiteral("peelThroughGaps"));
        auto* jump = options->findChild<QDoubleSpinBox*>(QStringLiteral("peelJump"));
        QVERIFY(!through->isChecked());
        QCOMPARE(jump->value(), core::PeelCut().jumpMm);
        fixture.peel.setDepthMm(30.0); // to the back of the head
        fixture.draw(30.0);
        const std::int64_t shell = fixture.carvedVoxels();
        through->click();
        QVERIFY(fixture.peel.isOpen());
        QCOMPARE(fixture.rows(), std::size_t(0));
        // It begins anew when the engine has taken the other one back.
        QTRY_VERIFY(fixture.carvedVoxels() > shell);
        through->click();
        QTRY_COMPARE(fixture.carvedVoxels(), shell);
        jump->setValue(0.0);
        QCOMPARE(jump->text(), QStringLiteral("all surfaces"));
        fixture.click();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(1));
        const auto& edit = fixture.session().history().rows().back().edit.get<core::PeelCut>();
        QCOMPARE(edit.jumpMm, 0.0);
        QVERIFY(!edit.throughGaps);
        QCOMPARE(edit.depthMm, 30.0);

        ui::PeelTool other(fixture.workspace);
        other.applySettings(fixture.peel.settingsJson());
        QVERIFY(other.gaps() == fixture.peel.gaps());
    }

    void optionsFollow()
    {
        OutlineFixture fixture;
        QWidget bar;
        const std::unique_ptr<QWidget> options(fixture.peel.createOptions(&bar));
        auto* slider = options->findChild<QSlider*>(QStringLiteral("peelSlider"));
        auto* depth = options->findChild<QDoubleSpinBox*>(QStringLiteral("peelDepth"));
        auto* keep = options->findChild<QPushButton*>(QStringLiteral("peelKeep"));
        QVERIFY(!keep->isEnabled());
        fixture.draw(50.0);
        QVERIFY(keep->isEnabled());
        const std::int64_t before = fixture.carvedVoxels();
        slider->setValue(slider->value() - 5);
        QCOMPARE(depth->value(), 1.5);
        QVERIFY(fixture.carvedVoxels() < before);
        depth->setValue(4.0);
        QCOMPARE(fixture.carvedVoxels(), before);
        keep->click();
        QVERIFY(!keep->isEnabled());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(1));
    }

    void escapeTakesItBack()
    {
        OutlineFixture fixture;
        fixture.draw(60.0);
        QVERIFY(fixture.carvedVoxels() > 0);
        QTest::keyClick(&fixture.view, Qt::Key_Escape); // the pen is lifted
        QVERIFY(!fixture.peel.isOpen());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.carvedVoxels(), std::int64_t(0));
        QCOMPARE(fixture.rows(), std::size_t(0));
    }

    void whateverElseIsDoneKeepsIt()
    {
        OutlineFixture fixture;
        fixture.draw(60.0);
        fixture.click();
        fixture.draw(30.0);
        fixture.session().poll();
        QVERIFY(fixture.session().transactionOpen());
        QCOMPARE(fixture.rows(), std::size_t(1));
        fixture.workspace.setActiveTool(&fixture.scissors);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2));
        fixture.workspace.setActiveTool(&fixture.peel);
        fixture.draw(70.0);
        core::AddSegment segment;
        segment.name = QStringLiteral("Other");
        QVERIFY(fixture.session().apply(segment));
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.peel.isOpen());
        QCOMPARE(fixture.rows(), std::size_t(4));
    }

    void smallCurvesAreRefusedKindly()
    {
        OutlineFixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.draw(1.0);
        QVERIFY(!fixture.peel.isOpen());
        QVERIFY(said.back().front().toString().contains(QStringLiteral("Draw a curve")));
        QCOMPARE(fixture.rows(), std::size_t(0));
    }

    void theEraserEndRestores()
    {
        OutlineFixture fixture;
        fixture.peel.setDepthMm(8.0);
        fixture.draw(60.0);
        fixture.peel.confirm();
        QVERIFY(fixture.session().settle());
        const std::int64_t carved = fixture.carvedVoxels();
        fixture.draw(60.0, test::Pen::End::Eraser);
        fixture.peel.confirm();
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.session().history().rows().back().edit.get<core::PeelCut>().restore);
        QVERIFY(fixture.carvedVoxels() < carved / 2);
    }

    void scissorsCutAtOnce()
    {
        OutlineFixture fixture;
        fixture.workspace.setActiveTool(&fixture.scissors);
        fixture.draw(30.0);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(1));
        const std::int64_t through = fixture.carvedVoxels();
        QVERIFY(!fixture.session().history().rows().back().edit.get<core::ScissorsCut>().depthMm);
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());

        QWidget bar;
        const std::unique_ptr<QWidget> options(fixture.scissors.createOptions(&bar));
        options->findChild<QCheckBox*>(QStringLiteral("scissorsLimited"))->click();
        options->findChild<QDoubleSpinBox*>(QStringLiteral("scissorsDepth"))->setValue(3.0);
        fixture.draw(30.0);
        QVERIFY(fixture.session().settle());
        const auto& cut = fixture.session().history().rows().back().edit.get<core::ScissorsCut>();
        QCOMPARE(cut.depthMm.value_or(0.0), 3.0);
        QVERIFY(fixture.carvedVoxels() > 0 && fixture.carvedVoxels() < through / 2);
    }
};

BURIN_WINDOW_TEST(OutlineToolsUiTest)

} // namespace outlineToolsUiTest

#include "OutlineToolsUiTest.moc"
