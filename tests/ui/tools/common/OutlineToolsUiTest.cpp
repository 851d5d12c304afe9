// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/tools/sculpt/PeelTool.h"
#include "ui/tools/sculpt/ScissorsTool.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QtTest>

#include <cmath>

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
    [[nodiscard]] core::EditSession& session() { return *workspace.session(); }
    [[nodiscard]] std::size_t rows() { return session().history().rows().size(); }
    [[nodiscard]] QPointF middle() const { return QPointF(view.width(), view.height()) / 2.0; }

    /// An open ring around the middle: it closes by itself.
    void draw(double radiusPixels, test::Pen::End end = test::Pen::End::Tip)
    {
        test::Pen pen(view, end);
        const auto at = [&](int i) {
            const double t = 2.0 * M_PI * i / 40.0;
            return middle() + radiusPixels * QPointF(std::cos(t), std::sin(t));
        };
        pen.press(at(0), 0.5, ++m_milliseconds);
        for (int i = 1; i < 38; ++i)
            pen.move(at(i), 0.5, m_milliseconds += 8);
        pen.release(at(38), m_milliseconds += 8);
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
        fixture.peel.changeDepth(4); // Alt + wheel
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
        fixture.draw(30.0); // the next curve
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
#include "OutlineToolsUiTest.moc"
