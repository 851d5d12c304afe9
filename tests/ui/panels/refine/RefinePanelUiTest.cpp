// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/frame/PanelSection.h"
#include "ui/panels/refine/RefinePanel.h"
#include "ui/workspace/Refinement.h"

#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QtTest>

namespace refinePanelUiTest {

namespace {

/// A ball as segment 1, and the panel.
class PanelFixture : public test::WorkspaceFixture {
public:
    PanelFixture()
        : panel(workspace)
    {
        apply(test::ballMask(glm::ivec3(test::smallHead::side), 10.0));
        workspace.setActiveSegment(1);
    }
    [[nodiscard]] QPushButton& button(const char* name) const
    {
        return *panel.findChild<QPushButton*>(QLatin1String(name));
    }

    ui::RefinePanel panel;
};

} // namespace

/// What the panel has of the surface as a whole.
class RefinePanelUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// In the narrowest column, only the controls for making a surface are shown, with all their
    /// words.
    void beforeASurfaceNothingIsEmptyOrCutOff()
    {
        PanelFixture fixture;
        QWidget& panel = fixture.panel;
        panel.setFixedWidth(ui::PanelSection::leastWidth);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        const auto& fineness = *panel.findChild<QSpinBox*>(QStringLiteral("surfaceVertices"));
        const auto& typed = *fineness.findChild<QLineEdit*>();
        QVERIFY(typed.width() > typed.fontMetrics().horizontalAdvance(fineness.specialValueText()));
        const QPushButton& lay = fixture.button("laySurface");
        QVERIFY(lay.isVisible() && lay.width() >= lay.sizeHint().width());
        QVERIFY(!fixture.button("saveSurface").isVisible());
        const int before = panel.sizeHint().height();
        fixture.apply(
            core::LaySurface{.segment = 1, .vertices = 800, .rules = core::newestSurfaceRules});
        QVERIFY(!lay.isVisible());
        QVERIFY(fixture.button("saveSurface").isVisible());
        QVERIFY2(2 * before < panel.sizeHint().height(), qPrintable(QString::number(before)));
    }

    void layingIsAborted()
    {
        PanelFixture fixture;
        QVERIFY(fixture.button("abortSurface").isHidden());
        fixture.workspace.refinement().lay(20000);
        QTRY_VERIFY(!fixture.button("abortSurface").isHidden());
        const int row = fixture.session().history().position();
        fixture.button("abortSurface").click();
        const auto settled = fixture.session().settle();
        QVERIFY(!settled);
        QCOMPARE(settled.error().code, core::ErrorCode::Cancelled);
        QCOMPARE(fixture.session().history().position(), row);
        QVERIFY(!fixture.workspace.refinement().surface());
        QTRY_VERIFY(fixture.button("abortSurface").isHidden());
    }

    /// A growth changes the mask under the surface, and that is seen at once.
    void aGrowthBringsTheCaution()
    {
        PanelFixture fixture;
        fixture.apply(test::seedAt(1, {{10.5, 0.5, 0.5}})); // beside the ball, in the brain
        fixture.apply(
            core::LaySurface{.segment = 1, .vertices = 3000, .rules = core::newestSurfaceRules});
        const auto& state = *fixture.panel.findChild<QLabel*>(QStringLiteral("surfaceState"));
        QVERIFY(!fixture.button("writeBack").isEnabled());
        QCOMPARE(state.property("role").toString(), QStringLiteral("plain"));
        fixture.apply(test::growBetween(0.0, 100.0, 3));
        QVERIFY(fixture.button("writeBack").isEnabled());
        QCOMPARE(state.property("role").toString(), QStringLiteral("caution"));
        QVERIFY2(state.text().contains(QLatin1String("does not hold")), qPrintable(state.text()));
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QVERIFY(!fixture.button("writeBack").isEnabled());
        QCOMPARE(state.property("role").toString(), QStringLiteral("plain"));
    }

    void aTemplateIsAborted()
    {
        PanelFixture fixture;
        fixture.apply(
            core::LaySurface{.segment = 1, .vertices = 12000, .rules = core::newestSurfaceRules});
        fixture.apply(core::MarkSurface{.mark = core::SurfaceMark::Red,
            .path = {.radiusMm = 12.0,
                .pointsLps = {glm::dvec3(10.0, 0.0, 0.0)},
                .rules = core::newestSurfaceRules}});
        const QByteArray before = fixture.session().stateHash();
        const core::RowId row = fixture.session().history().position();
        std::vector<glm::dvec3> lobe;
        for (int i = -8; i <= 8; ++i)
            lobe.emplace_back(14.0 - 0.15 * i * i, double(i), 0.0);
        fixture.workspace.refinement().addContour(lobe);
        QVERIFY(fixture.button("abortSurface").isHidden());
        fixture.workspace.refinement().previewTemplate();
        QVERIFY(fixture.workspace.refinement().isPreviewing());
        QTRY_VERIFY(!fixture.button("abortSurface").isHidden());
        fixture.button("abortSurface").click();
        QVERIFY(!fixture.workspace.refinement().isPreviewing());
        const auto settled = fixture.session().settle();
        QVERIFY(!settled);
        QCOMPARE(settled.error().code, core::ErrorCode::Cancelled);
        QCOMPARE(fixture.session().history().position(), row);
        QCOMPARE(fixture.session().stateHash(), before);
        // What was drawn stays.
        QCOMPARE(fixture.workspace.refinement().contours().size(), std::size_t(1));
        QTRY_VERIFY(fixture.button("abortSurface").isHidden());
    }

    /// Whoever takes it before the refusal has come has not drawn in vain.
    void aTemplateThatWasTakenTooSoonIsNotLost()
    {
        PanelFixture fixture;
        ui::Refinement& refinement = fixture.workspace.refinement();
        fixture.apply(core::LaySurface{.segment = 1, .vertices = 800});
        const std::size_t rows = fixture.session().history().rows().size();
        std::vector<glm::dvec3> lobe;
        for (int i = -8; i <= 8; ++i)
            lobe.emplace_back(14.0 - 0.15 * i * i, double(i), 0.0);
        refinement.addContour(lobe);
        const std::vector<std::vector<glm::dvec3>> drawn = refinement.contours();
        // Nothing is red, so that it will be refused.
        refinement.previewTemplate();
        refinement.takeTemplate();
        QVERIFY(refinement.contours().empty());
        QSignalSpy told(&refinement, &ui::Refinement::contoursChanged);
        QVERIFY(!fixture.session().settle());
        QVERIFY(refinement.contours() == drawn);
        QCOMPARE(told.size(), 1);
        QCOMPARE(fixture.session().history().rows().size(), rows);
        // What is removed then does not come back with another failure.
        refinement.removeContour();
        fixture.workspace.fail({core::ErrorCode::Cancelled, {}});
        QVERIFY(refinement.contours().empty());
        // With a red region it is taken, and over.
        fixture.apply(core::MarkSurface{
            .mark = core::SurfaceMark::Red, .path = {.radiusMm = 12.0, .pointsLps = {{10, 0, 0}}}});
        refinement.addContour(lobe);
        refinement.previewTemplate();
        refinement.takeTemplate();
        fixture.settle();
        QVERIFY(fixture.session().history().rows().size() > rows + 1);
        fixture.workspace.fail({core::ErrorCode::Cancelled, {}});
        QVERIFY(refinement.contours().empty());
    }

    /// Whoever took it at once, and then thinks better of it, has not drawn in vain.
    void aTakenTemplateIsAborted()
    {
        PanelFixture fixture;
        ui::Refinement& refinement = fixture.workspace.refinement();
        fixture.apply(
            core::LaySurface{.segment = 1, .vertices = 6000, .rules = core::newestSurfaceRules});
        fixture.apply(core::MarkSurface{.mark = core::SurfaceMark::Red,
            .path = {.radiusMm = 12.0,
                .pointsLps = {glm::dvec3(10.0, 0.0, 0.0)},
                .rules = core::newestSurfaceRules}});
        const QByteArray before = fixture.session().stateHash();
        std::vector<glm::dvec3> lobe;
        for (int i = -8; i <= 8; ++i)
            lobe.emplace_back(14.0 - 0.15 * i * i, double(i), 0.0);
        refinement.addContour(lobe);
        const std::vector<std::vector<glm::dvec3>> drawn = refinement.contours();
        refinement.previewTemplate();
        refinement.takeTemplate();
        QVERIFY(refinement.contours().empty());
        QVERIFY(refinement.isAbortable());
        QSignalSpy told(&refinement, &ui::Refinement::contoursChanged);
        refinement.abort();
        QVERIFY(refinement.contours() == drawn);
        QCOMPARE(told.size(), 1);
        // It may have been through before; then it is a row, and the contours are gone after all.
        const auto settled = fixture.session().settle();
        QCOMPARE(refinement.contours().size(), std::size_t(settled ? 0 : 1));
        QCOMPARE(fixture.session().stateHash() == before, !settled);
        if (settled) {
            refinement.addContour(lobe);
            QVERIFY(fixture.session().undo() && fixture.session().settle());
        } else {
            QCOMPARE(settled.error().code, core::ErrorCode::Cancelled);
        }
        // Taken and through it is over: what is aborted later brings nothing back.
        refinement.previewTemplate();
        refinement.takeTemplate();
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.session().stateHash() != before);
        QVERIFY(refinement.contours().empty());
        refinement.followMask();
        QVERIFY(refinement.isAbortable());
        refinement.abort();
        QVERIFY(refinement.contours().empty());
        static_cast<void>(fixture.session().settle());
        QVERIFY(refinement.contours().empty());
    }

    void theSurfaceIsSaved_data()
    {
        QTest::addColumn<QString>("ending");
        for (const char* ending : {"stl", "ply", "obj", "glb"})
            QTest::newRow(ending) << QString::fromLatin1(ending);
    }
    void theSurfaceIsSaved()
    {
        QFETCH(QString, ending);
        PanelFixture fixture;
        fixture.apply(core::LaySurface{.segment = 1, .vertices = 800});
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("ball.") + ending);
        fixture.panel.save(path);
        QTRY_VERIFY(QFileInfo(path).size() > 10000);
    }
};

BURIN_WINDOW_TEST(RefinePanelUiTest)

} // namespace refinePanelUiTest

#include "RefinePanelUiTest.moc"
