// SPDX-License-Identifier: Apache-2.0
#include "core/recipe/RecipeElsewhere.h"
#include "core/edits/EditJson.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/pieces/RemovePiece.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/views/Measurements.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <set>

namespace recipeElsewhereTest {

using namespace core;

namespace {

Recipe recipeOf(std::vector<RecipeStep> steps)
{
    return {.path = QStringLiteral("r.json"),
        .study = {},
        .steps = std::move(steps),
        .entries = {},
        .withoutSurface = {},
        .exports = {}};
}

ChangeSegment rename(int segment, const char* name)
{
    return {.segment = segment, .name = QLatin1String(name)};
}

HistoryMove undo()
{
    return {.kind = HistoryMove::Kind::Undo, .row = 0};
}

LayerToSegment layerToNew(const char* name)
{
    return {.layer = 1, .target = {.segment = {}, .name = QLatin1String(name), .rgb = 1}};
}

} // namespace

/// What a step made keeps its meaning under whatever number it has here, and nothing acts on what
/// it was not about.
class RecipeElsewhereTest : public QObject {
    Q_OBJECT

private:
    /// Carries out on a document what is not left out, voxels or not.
    /// @param barren steps of which nothing comes here
    static QStringList carryOut(
        RecipeElsewhere& recipe, Document& document, const std::set<std::size_t>& barren = {})
    {
        QStringList leftOut;
        for (std::size_t i = 0; i < recipe.recorded().steps.size(); ++i) {
            const auto edit = recipe.here(i, document);
            if (!edit) {
                leftOut += QString::number(edit.error().entry)
                    + (edit.error().bound ? QStringLiteral(" bound")
                                          : QStringLiteral(": ") + edit.error().why);
                continue;
            }
            const Document before = document;
            if (barren.count(i) == 0 && !applyToDocument(*edit, document))
                leftOut += QStringLiteral("%1 failed").arg(i + 1);
            recipe.carriedOut(i, before, document);
        }
        return leftOut;
    }
    static QStringList segments(const Document& document)
    {
        QStringList names;
        for (const Segment& segment : document.segments)
            names += segment.name;
        return names;
    }

private Q_SLOTS:
    void numbersAreThoseOfTheSameMaker()
    {
        RecipeElsewhere recipe(
            recipeOf({test::drillAt(0), layerToNew("Cap"), test::addSegment("Bone"),
                test::addSegment("Skin"), rename(2, "Bone, done"), rename(1, "Cap, done"),
                RemoveSegment{.segment = 3}, test::addSegment("More"), rename(4, "More, done")}));
        Document nothingCame = initialDocument({});
        RecipeElsewhere first = recipe;
        QCOMPARE(carryOut(first, nothingCame, {1}),
            (QStringList{QStringLiteral("1 bound"),
                QStringLiteral("6: the segment that edit 2 (layerToSegment) makes is not here")}));
        QCOMPARE(segments(nothingCame),
            (QStringList{QStringLiteral("Bone, done"), QStringLiteral("More, done")}));

        Document goesOn = initialDocument({});
        QVERIFY(applyToDocument(test::addSegment("Own"), goesOn));
        QVERIFY(applyToDocument(test::addSegment("Other"), goesOn));
        QCOMPARE(carryOut(recipe, goesOn), QStringList{QStringLiteral("1 bound")});
        QCOMPARE(segments(goesOn),
            (QStringList{QStringLiteral("Own"), QStringLiteral("Other"),
                QStringLiteral("Cap, done"), QStringLiteral("Bone, done"),
                QStringLiteral("More, done")}));
    }

    /// Whatever names a segment does, a surface too.
    void aSurfaceLiesAroundTheSegmentThatItLayAround()
    {
        RecipeElsewhere recipe(recipeOf({test::addSegment("Bone"), LaySurface{.segment = 1}}));
        Document document = initialDocument({});
        QVERIFY(applyToDocument(test::addSegment("Own"), document));
        const Result<bool> added = applyToDocument(test::addSegment("Bone"), document);
        QVERIFY(added);
        Document before = initialDocument({});
        QVERIFY(applyToDocument(test::addSegment("Own"), before));
        recipe.carriedOut(0, before, document);
        const auto lay = recipe.here(1, document);
        QVERIFY(lay);
        QCOMPARE(lay->get<LaySurface>().segment, 2);
    }

    void whatWasTakenBackGivesNoNumber()
    {
        // Segment 1 is B: A was taken back. Walks are left out, so A is 1 here.
        RecipeElsewhere recipe(
            recipeOf({test::addSegment("A"), undo(), test::addSegment("B"), rename(1, "B, done")}));
        Document document = initialDocument({});
        QCOMPARE(carryOut(recipe, document), QStringList{QStringLiteral("2 bound")});
        QCOMPARE(segments(document), (QStringList{QStringLiteral("A"), QStringLiteral("B, done")}));
    }

    void piecesLayersAndMeasurementsLikewise()
    {
        const AddMeasurement measured{.fromLps = {0, 0, 0}, .toLps = {5, 0, 0}};
        RecipeElsewhere recipe(recipeOf({AddLayer{.name = QStringLiteral("L2")},
            CutPiece{.layer = 1, .name = QStringLiteral("P"), .pivotLps = glm::dvec3(1.0)},
            CutPiece{.layer = 2, .name = QStringLiteral("Q")}, ChangePiece{.piece = 1, .zoom = 2.0},
            ChangePiece{.piece = 2, .zoom = 3.0}, measured, RemoveMeasurement{.measurement = 1},
            RemovePiece{.piece = 1}, ChangeLayer{.layer = 2, .name = QStringLiteral("L")}}));
        Document document = initialDocument({});
        QVERIFY(applyToDocument(AddLayer{.name = QStringLiteral("own")}, document));
        QCOMPARE(carryOut(recipe, document),
            (QStringList{QStringLiteral("2 bound"),
                QStringLiteral("4: the piece that edit 2 (cutPiece) makes is not here"),
                QStringLiteral("6 bound"),
                QStringLiteral("7: the measurement that edit 6 (addMeasurement) makes is not here"),
                QStringLiteral("8: the piece that edit 2 (cutPiece) makes is not here")}));
        QCOMPARE(document.pieces.size(), std::size_t(1));
        QCOMPARE(document.pieces.front().pose.zoom, 3.0);
        QCOMPARE(document.pieces.front().layer, 3);
        QCOMPARE(document.layer(2)->name, QStringLiteral("own"));
        QCOMPARE(document.layer(3)->name, QStringLiteral("L"));
    }

    void whatNoStepMakesIsLeftAlone()
    {
        RecipeElsewhere recipe(recipeOf({rename(1, "Mine")}));
        Document document = initialDocument({});
        QVERIFY(applyToDocument(test::addSegment("Yours"), document));
        QCOMPARE(carryOut(recipe, document),
            QStringList{QStringLiteral("1: no edit before it makes a segment 1")});
        QCOMPARE(segments(document), QStringList{QStringLiteral("Yours")});
    }

    /// How many segments become of islands is known only when they are counted: a number from there
    /// on may be one of them, or that of a segment that was made later.
    void segmentsAfterIslandsWereSplitAreUnknown()
    {
        RecipeElsewhere recipe(recipeOf({test::addSegment("Organ"), SplitIslands{.segment = 1},
            test::addSegment("Bone"), rename(2, "Part"), rename(1, "Organ, done")}));
        Document document = initialDocument({});
        QCOMPARE(carryOut(recipe, document),
            QStringList{QStringLiteral("4: no edit before it makes a segment 2")});
        QCOMPARE(segments(document),
            (QStringList{QStringLiteral("Organ, done"), QStringLiteral("Bone")}));

        RecipeElsewhere undone(recipeOf({test::addSegment("Organ"), SplitIslands{.segment = 1},
            undo(), test::addSegment("Bone"), rename(2, "Bone, done")}));
        Document other = initialDocument({});
        QCOMPARE(carryOut(undone, other), QStringList{QStringLiteral("3 bound")});
        QCOMPARE(
            segments(other), (QStringList{QStringLiteral("Organ"), QStringLiteral("Bone, done")}));
    }

    void whatIsForeseenIsChecked()
    {
        Recipe recorded = recipeOf({test::drillAt(0), test::addSegment("A"),
            CutPiece{.layer = 1, .name = QStringLiteral("P"), .pivotLps = glm::dvec3(1.0)},
            RemovePiece{.piece = 1}, rename(1, "B")});
        const RecipeElsewhere recipe(recorded);
        const RecipeElsewhere::Foreseen foreseen = recipe.foreseen(initialDocument({}));
        QCOMPARE(foreseen.recipe.entries, (std::vector<int>{2, 5}));
        QCOMPARE(foreseen.leftOut.size(), std::size_t(3));
        QCOMPARE(foreseen.leftOut[2].entry, 4);
        QVERIFY(checkRecipe(foreseen.recipe, initialDocument({}), false));
        // The entry that is told is the recipe's own, however many come before it.
        Recipe wrong = foreseen.recipe;
        wrong.steps[1] = rename(7, "C");
        const Result<void> checked = checkRecipe(wrong, initialDocument({}), false);
        QVERIFY(!checked);
        QVERIFY2(checked.error().arguments.value(1).contains(QStringLiteral("(edit 5)")),
            qPrintable(checked.error().arguments.join(u' ')));
    }
};

BURIN_TEST(RecipeElsewhereTest)

} // namespace recipeElsewhereTest

#include "RecipeElsewhereTest.moc"
