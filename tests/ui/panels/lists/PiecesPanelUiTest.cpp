// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/PiecesPanel.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/LayerActions.h"
#include "ui/workspace/LayerLooks.h"
#include "ui/workspace/Pieces.h"

#include <QComboBox>
#include <QtTest>

#include <cstdint>

namespace piecesPanelUiTest {

namespace {

/// The small head with a cut in layer 1 and a segment, and the panel.
class PiecesFixture : public test::WindowFixture {
public:
    PiecesFixture()
        : test::WindowFixture(test::smallHead::volume())
        , panel(new ui::PiecesPanel(workspace, window.views().volume()))
        , pieces(workspace.pieces())
    {
        window.addPanel(panel);
        window.showPanels(true);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        apply(test::carveAt({{-6, 0, 14}, {6, 0, 14}}, 8.0));
        apply(test::newSegment(QStringLiteral("Tooth"), 0x40C080));
        apply(test::paintAt(1, {{4, 0, -6}}, 5.0));
    }
    void settle()
    {
        // What an answer asks for is asked after it came.
        for (int i = 0; i < 5; ++i) {
            const auto measured = [this] { return !pieces.isMeasuring(); };
            if (!session().settle() || !QTest::qWaitFor(measured, 60000))
                qFatal("not settled");
        }
    }
    void lift()
    {
        pieces.lift(1);
        settle();
    }
    void paste(int segment = 1)
    {
        pieces.paste(segment);
        settle();
    }
    void undo(int steps)
    {
        for (int i = 0; i < steps; ++i)
            QVERIFY(session().undo());
        settle();
    }
    void redo(int steps)
    {
        for (int i = 0; i < steps; ++i)
            QVERIFY(session().redo());
        settle();
    }
    [[nodiscard]] const std::vector<core::Piece>& all() { return session().document().pieces; }
    /// The number of the only piece; 0: there is none, or another.
    [[nodiscard]] int onlyPiece() { return all().size() == 1 ? all().front().id : 0; }

    ui::PiecesPanel* panel;
    ui::Pieces& pieces;
};

} // namespace

/// Pieces as the list shows them: what they look like, and which there can be.
class PiecesPanelUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A new piece that takes the number of an undone one looks like a new one; redo brings the
    /// old one back as it was.
    void aNewPieceLooksLikeOne_data()
    {
        QTest::addColumn<bool>("isCut");
        QTest::newRow("cut out") << true;
        QTest::newRow("pasted") << false;
    }
    void aNewPieceLooksLikeOne()
    {
        QFETCH(const bool, isCut);
        PiecesFixture fixture;
        const std::size_t before = fixture.rows();
        const auto make = [&] { isCut ? fixture.lift() : fixture.paste(); };
        make();
        const int steps = int(fixture.rows() - before); // a cut-out one also brings a layer
        const int number = fixture.onlyPiece();
        QVERIFY(number > 0);
        ui::PieceLook faint;
        faint.visible = false;
        faint.opacity = 0.3;
        fixture.pieces.setLook(number, faint);
        fixture.undo(steps);
        QVERIFY(fixture.all().empty());
        fixture.redo(steps);
        QCOMPARE(fixture.onlyPiece(), number);
        QVERIFY(fixture.pieces.look(number) == faint);
        fixture.undo(steps);
        make();
        QCOMPARE(fixture.onlyPiece(), number);
        QVERIFY(fixture.pieces.look(number) == ui::PieceLook());
        QCOMPARE(fixture.pieces.scene().front().opacity, 1.0f);
    }

    /// What was cut out has no body in a colour, so there is no such choice.
    void wholeIsForSegmentsAlone()
    {
        PiecesFixture fixture;
        const auto* map = fixture.panel->findChild<QComboBox*>(QStringLiteral("pieceMap"));
        QVERIFY(map);
        const auto isWholeOffered = [map] {
            const int row = map->findText(QStringLiteral("Whole"));
            return row >= 0 && map->model()->flags(map->model()->index(row, 0)) & Qt::ItemIsEnabled;
        };
        fixture.lift();
        QVERIFY(!isWholeOffered());
        QCOMPARE(map->currentText(), QStringLiteral("As volume"));
        fixture.paste();
        QCOMPARE(fixture.pieces.active(), fixture.all().back().id);
        QVERIFY(isWholeOffered());
        QCOMPARE(map->currentText(), QStringLiteral("Whole"));
        fixture.pieces.setActive(fixture.all().front().id);
        QVERIFY(!isWholeOffered());
    }

    /// A single voxel is something, wherever it lies.
    void theSmallestPieceIsOne()
    {
        PiecesFixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        int segment = 1;
        for (const glm::dvec3& index :
            {glm::dvec3(2, 2, 2), glm::dvec3(2, 2, 3), glm::dvec3(2, 3, 3)}) {
            const glm::dvec3 place = fixture.place(index);
            fixture.apply(test::newSegment(QStringLiteral("Speck")));
            fixture.apply(test::paintAt(++segment, {place}, 0.4));
            QCOMPARE(fixture.session().document().segment(segment)->voxels, std::int64_t(1));
            fixture.paste(segment);
            QVERIFY(!fixture.all().empty());
            const core::Piece& piece = fixture.all().back();
            QCOMPARE(piece.segment, segment);
            QVERIFY(piece.pivotLps && glm::distance(*piece.pivotLps, place) < 0.1);
        }
        QCOMPARE(fixture.all().size(), std::size_t(3));
        // What is empty is not.
        fixture.apply(test::newSegment(QStringLiteral("Nothing")));
        said.clear();
        fixture.paste(++segment);
        QVERIFY(!said.isEmpty());
        QCOMPARE(fixture.all().size(), std::size_t(3));
    }

    void aNewLayerLooksLikeOne()
    {
        PiecesFixture fixture;
        ui::LayerLooks& looks = fixture.workspace.layerLooks();
        const ui::LayerLook faint{.hides = 0.4, .softness = 0.5};
        QCOMPARE(ui::addLayer(fixture.workspace).value_or(0), 2);
        fixture.settle();
        looks.setLook(2, faint);
        fixture.undo(1);
        fixture.redo(1);
        QVERIFY(looks.look(2) == faint);
        fixture.undo(1);
        QCOMPARE(ui::addLayer(fixture.workspace).value_or(0), 2);
        fixture.settle();
        QVERIFY(looks.look(2) == ui::LayerLook());

        // Nor does the layer that a lifted cut is given, which shows once it is no piece any more.
        looks.setLook(2, faint);
        fixture.undo(1);
        fixture.workspace.setActiveLayer(1);
        fixture.apply(test::carveAt({{-6, 0, -12}, {6, 0, -12}}, 5.0));
        fixture.pieces.liftCut(fixture.session().history().position());
        fixture.settle();
        QCOMPARE(fixture.onlyPiece(), 1);
        QCOMPARE(fixture.all().front().layer, 2);
        QVERIFY(looks.look(2) == ui::LayerLook());
    }
};

BURIN_WINDOW_TEST(PiecesPanelUiTest)

} // namespace piecesPanelUiTest

#include "PiecesPanelUiTest.moc"
