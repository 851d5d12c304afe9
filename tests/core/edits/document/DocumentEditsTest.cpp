// SPDX-License-Identifier: Apache-2.0
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/EditJson.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/layers/MergeLayers.h"
#include "core/edits/kinds/layers/MoveLayer.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/pieces/PastePiece.h"
#include "core/edits/kinds/pieces/RemovePiece.h"
#include "core/edits/kinds/pieces/SendPiecesHome.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/MoveSegment.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/views/Bookmarks.h"
#include "core/edits/kinds/views/Measurements.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QJsonDocument>
#include <QTest>

#include <cmath>

namespace documentEditsTest {

using namespace core;

namespace {

QByteArray stateOf(const Document& document)
{
    return QJsonDocument(document.hashedState()).toJson(QJsonDocument::Compact);
}

AddSegment segment(const char* name)
{
    return {.name = QLatin1String(name), .rgb = 0x40C080};
}

AddBookmark bookmark(const char* name)
{
    AddBookmark add;
    add.name = QLatin1String(name);
    add.view = {.eyeLps = {0, -400, 10}, .targetLps = {0, 0, 10}, .up = {0, 0, 1}, .heightMm = 250};
    add.crosshairLps = {1.5, -2, 3};
    return add;
}

CutPiece lift(int layer, const char* name)
{
    return {.layer = layer, .name = QLatin1String(name)};
}

/// Two segments, two layers, two bookmarks.
Document furnished()
{
    Document document = initialDocument({});
    for (const Edit& edit : std::vector<Edit>{segment("Skull"), segment("Brain"),
             AddLayer{.name = QStringLiteral("Approach")}, bookmark("Front"), bookmark("Left")})
        static_cast<void>(applyToDocument(edit, document));
    return document;
}

template <class T> std::vector<int> numbersOf(const std::vector<T>& list, auto number)
{
    std::vector<int> numbers;
    for (const T& entry : list)
        numbers.push_back(number(entry));
    return numbers;
}
std::vector<int> labels(const Document& document)
{
    return numbersOf(document.segments, [](const Segment& s) { return int(s.label); });
}
std::vector<int> layers(const Document& document)
{
    return numbersOf(document.layers, [](const SculptLayer& l) { return int(l.id); });
}
std::vector<int> bookmarks(const Document& document)
{
    return numbersOf(document.bookmarks, [](const CameraBookmark& b) { return b.id; });
}

} // namespace

} // namespace documentEditsTest

Q_DECLARE_METATYPE(core::Edit)

namespace documentEditsTest {

class DocumentEditsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void changingNothingIsNoChange_data()
    {
        QTest::addColumn<Edit>("edit");
        QTest::newRow("the same name")
            << Edit(ChangeSegment{.segment = 1, .name = QStringLiteral("Skull")});
        QTest::newRow("the same colour") << Edit(ChangeSegment{.segment = 1, .rgb = 0x40C080});
        QTest::newRow("the same code") << Edit(ChangeSegment{.segment = 1, .code = CodedConcept{}});
        QTest::newRow("unlock an unlocked one")
            << Edit(ChangeSegment{.segment = 1, .locked = false});
        QTest::newRow("nothing at all") << Edit(ChangeSegment{.segment = 1});
        QTest::newRow("the same place") << Edit(MoveSegment{.segment = 1, .place = 1});
        QTest::newRow("the last behind the last") << Edit(MoveSegment{.segment = 2, .place = 99});
        QTest::newRow("the same layer name")
            << Edit(ChangeLayer{.layer = 2, .name = QStringLiteral("Approach")});
        QTest::newRow("unmute what is heard") << Edit(ChangeLayer{.layer = 2, .muted = false});
        QTest::newRow("nothing of a layer") << Edit(ChangeLayer{.layer = 2});
        QTest::newRow("the same place of a layer") << Edit(MoveLayer{.layer = 2, .place = 2});
        QTest::newRow("the last layer behind the last") << Edit(MoveLayer{.layer = 2, .place = 99});
    }
    void changingNothingIsNoChange()
    {
        QFETCH(Edit, edit);
        Document document = furnished();
        const QByteArray before = stateOf(document);
        const Result<bool> changed = applyToDocument(edit, document);
        QVERIFY(changed);
        QVERIFY(!*changed);
        QCOMPARE(stateOf(document), before);
        QVERIFY(checkAgainst(document, edit));
    }

    void whatIsNotThereIsNamed_data()
    {
        QTest::addColumn<Edit>("edit");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("argument");
        const auto row = [](const char* name, const Edit& edit, ErrorCode code, const char* first) {
            QTest::newRow(name) << edit << int(code) << QString(QLatin1String(first));
        };
        row("segment", RemoveSegment{.segment = 3}, ErrorCode::UnknownSegment, "3");
        row("locked segment", RemoveSegment{.segment = 2}, ErrorCode::SegmentLocked, "Brain");
        row("layer", ChangeLayer{.layer = 3, .muted = true}, ErrorCode::InvalidField,
            "changeLayer.layer");
        row("layer to move", MoveLayer{.layer = 3, .place = 1}, ErrorCode::InvalidField,
            "moveLayer.layer");
        row("bookmark", RemoveBookmark{.bookmark = 3}, ErrorCode::InvalidField,
            "removeBookmark.bookmark");
        row("layer to delete", RemoveLayer{.layer = 3}, ErrorCode::InvalidField,
            "removeLayer.layer");
        row("layer to merge", MergeLayers{.from = 3, .into = 1}, ErrorCode::InvalidField,
            "mergeLayers.from");
        row("layer to merge into", MergeLayers{.from = 1, .into = 3}, ErrorCode::InvalidField,
            "mergeLayers.into");
        row("layer to lift", CutPiece{.layer = 3}, ErrorCode::InvalidField, "cutPiece.layer");
        row("layer that is lifted", CutPiece{.layer = 1}, ErrorCode::InvalidField,
            "cutPiece.layer");
        row("segment to paste", PastePiece{.segment = 3}, ErrorCode::UnknownSegment, "3");
        row("piece", ChangePiece{.piece = 3}, ErrorCode::InvalidField, "changePiece.piece");
        row("piece to remove", RemovePiece{.piece = 3}, ErrorCode::InvalidField,
            "removePiece.piece");
        row("measurement", RemoveMeasurement{.measurement = 3}, ErrorCode::InvalidField,
            "removeMeasurement.measurement");
        row("measurement to move",
            MoveMeasurement{.measurement = 3, .pointsLps = {{1, 2, 3}, {4, 5, 6}}},
            ErrorCode::InvalidField, "moveMeasurement.measurement");
        const glm::dvec3 place(1, 2, 3);
        row("no distance", AddMeasurement{.fromLps = place, .toLps = place},
            ErrorCode::InvalidField, "addMeasurement.toLps");
        row("piece to measure", AddMeasurement{.toLps = place, .piece = 3}, ErrorCode::InvalidField,
            "addMeasurement.piece");
        using Kind = Measurement::Kind;
        const auto annotated = [&row](const char* name, Kind kind,
                                   const std::vector<glm::dvec3>& points, const char* field) {
            row(name, Annotate{.kind = kind, .pointsLps = points}, ErrorCode::InvalidField, field);
        };
        const glm::dvec3 other(4, 6, 3);
        annotated("distance to annotate", Kind::Distance, {place, other}, "annotate.kind");
        annotated("angle of two points", Kind::Angle, {place, other}, "annotate.pointsLps");
        annotated("angle of four", Kind::Angle, {place, other, {0, 0, 0}, {9, 9, 9}},
            "annotate.pointsLps");
        annotated("angle without a side", Kind::Angle, {place, place, other}, "annotate.pointsLps");
        annotated(
            "angle without the other", Kind::Angle, {other, place, place}, "annotate.pointsLps");
        annotated("ellipse on a line", Kind::Ellipse, {place, {2, 2, 3}, {7, 2, 3}},
            "annotate.pointsLps");
        annotated(
            "rectangle of one side", Kind::Rectangle, {place, other, other}, "annotate.pointsLps");
        annotated("bent outline", Kind::Outline, {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 1}},
            "annotate.pointsLps");
        annotated("ball of no radius", Kind::Ball, {place, place}, "annotate.pointsLps");
        annotated("probe of two places", Kind::Probe, {place, other}, "annotate.pointsLps");
        annotated("text of no words", Kind::Text, {place}, "annotate.text");
        row("probe that says something",
            Annotate{.kind = Kind::Probe, .pointsLps = {place}, .text = QStringLiteral("Here")},
            ErrorCode::InvalidField, "annotate.text");
        row("piece to annotate", Annotate{.kind = Kind::Probe, .pointsLps = {place}, .piece = 3},
            ErrorCode::InvalidField, "annotate.piece");
        std::vector<glm::dvec3> round;
        for (int i = 0; i <= int(Annotate::mostCorners); ++i)
            round.emplace_back(std::cos(0.01 * i), std::sin(0.01 * i), 0.0);
        annotated("too many corners", Kind::Outline, round, "annotate.pointsLps");
        AddBookmark nowhere = bookmark("Nowhere");
        nowhere.view.eyeLps = nowhere.view.targetLps;
        row("view of nothing", nowhere, ErrorCode::InvalidField, "addBookmark.view");
        nowhere = bookmark("Along");
        nowhere.view.up = {0, 1, 0};
        row("view along its up", nowhere, ErrorCode::InvalidField, "addBookmark.view.up");
    }
    void whatIsNotThereIsNamed()
    {
        QFETCH(Edit, edit);
        QFETCH(int, code);
        QFETCH(QString, argument);
        Document document = furnished();
        QVERIFY(applyToDocument(ChangeSegment{.segment = 2, .locked = true}, document));
        QVERIFY(applyToDocument(lift(1, "Lid"), document));
        const QByteArray before = stateOf(document);
        const Result<bool> changed = applyToDocument(edit, document);
        QVERIFY(!changed);
        QCOMPARE(int(changed.error().code), code);
        QCOMPARE(changed.error().arguments.value(0), argument);
        QCOMPARE(stateOf(document), before);
        QVERIFY(!checkAgainst(document, edit));
    }

    void numbersAreNeverUsedAgain()
    {
        Document document = furnished();
        QVERIFY(applyToDocument(RemoveSegment{.segment = 2}, document));
        QVERIFY(applyToDocument(segment("Third"), document));
        QVERIFY(labels(document) == (std::vector<int>{1, 3}));
        QVERIFY(applyToDocument(RemoveSegment{.segment = 1}, document));
        QVERIFY(applyToDocument(RemoveSegment{.segment = 3}, document));
        QVERIFY(applyToDocument(segment("Fourth"), document));
        QVERIFY(labels(document) == std::vector<int>{4});

        QVERIFY(applyToDocument(RemoveBookmark{.bookmark = 2}, document));
        QVERIFY(applyToDocument(bookmark("Third"), document));
        QVERIFY(bookmarks(document) == (std::vector<int>{1, 3}));
    }

    /// A distance is hashed as it always was; whatever else is kept says what it is.
    void whatIsMeasuredIsPartOfTheState()
    {
        Document document = initialDocument({});
        QVERIFY(applyToDocument(
            AddMeasurement{.fromLps = {1, 2, 3}, .toLps = {4, 6, 3}, .piece = {}}, document));
        QVERIFY(stateOf(document).contains(
            R"("measurements":[{"fromLps":[1,2,3],"id":1,"toLps":[4,6,3]}])"));
        QCOMPARE(document.measurements[0].lengthMm(), 5.0);
        const QByteArray alone = stateOf(document);
        QVERIFY(applyToDocument(Annotate{.kind = Measurement::Kind::Arrow,
                                    .pointsLps = {{1, 2, 3}, {4, 6, 3}},
                                    .text = QStringLiteral("Here"),
                                    .projected = true},
            document));
        QVERIFY(stateOf(document).contains(
            R"({"id":2,"kind":"arrow","pointsLps":[[1,2,3],[4,6,3]],"projected":true,"text":"Here"})"));
        // Moved, it stays what it is.
        const MoveMeasurement move{.measurement = 2, .pointsLps = {{7, 2, 3}, {4, 6, 3}}};
        QVERIFY(*applyToDocument(move, document));
        QVERIFY(!*applyToDocument(move, document));
        QVERIFY(stateOf(document).contains(R"("pointsLps":[[7,2,3],[4,6,3]],"projected":true)"));
        QVERIFY(!applyToDocument(
            MoveMeasurement{.measurement = 2, .pointsLps = {{7, 2, 3}}}, document));
        QVERIFY(!applyToDocument(
            MoveMeasurement{.measurement = 1, .pointsLps = {{7, 2, 3}, {7, 2, 3}}}, document));
        QVERIFY(applyToDocument(RemoveMeasurement{.measurement = 2}, document));
        QVERIFY(stateOf(document) != alone); // its number is never used again
        QVERIFY(stateOf(document).contains(R"("lastMeasurement":2)"));
        QVERIFY(applyToDocument(
            Annotate{.kind = Measurement::Kind::Probe, .pointsLps = {{0, 0, 0}}}, document));
        QCOMPARE(document.measurements.back().id, 3);
    }

    void labelsRunOut()
    {
        Document document = initialDocument({});
        for (int label = 1; label <= 255; ++label) {
            QVERIFY(applyToDocument(segment("One of many"), document));
            QVERIFY(applyToDocument(RemoveSegment{.segment = label}, document));
        }
        const Result<bool> added = applyToDocument(segment("One too many"), document);
        QVERIFY(!added);
        QCOMPARE(added.error().code, ErrorCode::InvalidField);
        for (int layer = 2; layer <= 254; ++layer)
            QVERIFY(applyToDocument(AddLayer{.name = QStringLiteral("One of many")}, document));
        QVERIFY(!applyToDocument(AddLayer{.name = QStringLiteral("One too many")}, document));
        QCOMPARE(int(document.layers.back().id), 254);
    }

    void layersAreInOrder()
    {
        Document document = furnished();
        QVERIFY(applyToDocument(AddLayer{.name = QStringLiteral("Third")}, document));
        QVERIFY(layers(document) == (std::vector<int>{1, 2, 3}));
        QVERIFY(*applyToDocument(MoveLayer{.layer = 3, .place = 1}, document));
        QVERIFY(layers(document) == (std::vector<int>{3, 1, 2}));
        QVERIFY(*applyToDocument(MoveLayer{.layer = 3, .place = 2}, document));
        QVERIFY(layers(document) == (std::vector<int>{1, 3, 2}));
        QVERIFY(
            *applyToDocument(ChangeLayer{.layer = 3, .name = QStringLiteral("Named")}, document));
        QVERIFY(*applyToDocument(ChangeLayer{.layer = 3, .muted = true}, document));
        QCOMPARE(document.layer(3)->name, QStringLiteral("Named"));
        QVERIFY(document.layer(3)->muted);
    }

    void aStrokeNeedsALayerThatIsSeen()
    {
        Document document = furnished();
        const auto stroke = [view = bookmark("Front").view](int layer) {
            return test::drillWith(
                {.layer = layer, .view = view, .samples = std::vector<PenSample>(1)});
        };
        document.volumes.front().geometry.size = {10, 10, 10};
        document.volumes.front().geometry.indexToWorld = glm::dmat4(1.0);
        QVERIFY(checkAgainst(document, stroke(2)));
        QCOMPARE(checkAgainst(document, stroke(3)).error().arguments.value(0),
            QStringLiteral("drill.layer"));
        QVERIFY(applyToDocument(ChangeLayer{.layer = 2, .muted = true}, document));
        const Result<void> muted = checkAgainst(document, stroke(2));
        QVERIFY(!muted);
        QVERIFY(muted.error().arguments.value(1).contains(QStringLiteral("'Approach' is muted")));
    }

    void piecesFollowWhatTheyAreMadeOf()
    {
        Document document = furnished();
        const QByteArray before = stateOf(document);
        const PastePiece copy{.segment = 2, .name = QStringLiteral("Copy")};
        QVERIFY(applyToDocument(lift(2, "Lid"), document));
        QVERIFY(applyToDocument(copy, document));
        QVERIFY(applyToDocument(copy, document)); // as many of one segment as one likes
        QCOMPARE(document.pieces.size(), std::size_t(3));
        QCOMPARE(document.pieceOfLayer(2)->name, QStringLiteral("Lid"));
        QVERIFY(!document.pieceOfLayer(1));
        QVERIFY(applyToDocument(RemoveSegment{.segment = 2}, document));
        QCOMPARE(document.pieces.size(), std::size_t(1));
        QVERIFY(stateOf(document).contains("\"lastPiece\":3"));
        QVERIFY(
            applyToDocument(PastePiece{.segment = 1, .name = QStringLiteral("Other")}, document));
        QCOMPARE(document.pieces.back().id, 4);
        QVERIFY(!stateOf(document).contains("lastPiece"));
        QVERIFY(before != stateOf(document));

        const ChangePiece aside{.piece = 1,
            .offsetMm = glm::dvec3(40, 0, 0),
            .rotationDegrees = glm::dvec3(0, 0, 90),
            .zoom = 2.0};
        QVERIFY(*applyToDocument(aside, document));
        QVERIFY(!*applyToDocument(aside, document));
        QVERIFY(stateOf(document).contains(
            "\"pieces\":[{\"id\":1,\"layer\":2,\"name\":\"Lid\",\"offsetMm\":[40,0,0],"
            "\"rotationDegrees\":[0,0,90],\"zoom\":2}"));
        QVERIFY(*applyToDocument(SendPiecesHome{}, document));
        QVERIFY(!*applyToDocument(SendPiecesHome{}, document));
        QVERIFY(document.piece(1)->pose.isHome());
    }

    void piecesRunOut()
    {
        Document document = furnished();
        const PastePiece copy{.segment = 1, .name = QStringLiteral("Copy")};
        for (int i = 0; i < 64; ++i)
            QVERIFY(applyToDocument(copy, document));
        const Result<bool> one = applyToDocument(copy, document);
        QVERIFY(!one);
        QCOMPARE(one.error().arguments.value(0), QStringLiteral("pastePiece"));
    }

    void posesAreTurnsAboutThePivot()
    {
        VolumeGeometry geometry;
        geometry.size = {11, 21, 31};
        Piece piece{.id = 1, .layer = 1};
        QVERIFY(shownFromTrue(piece, geometry) == glm::dmat4(1.0));
        piece.pose.rotationDegrees = {0, 0, 90};
        piece.pose.zoom = 2.0;
        piece.pose.offsetMm = {100, 0, 0};
        // The middle (5, 10, 15) goes to itself; x runs to y, twice as far.
        const glm::dvec4 shown = shownFromTrue(piece, geometry) * glm::dvec4(8, 10, 15, 1);
        QVERIFY(glm::distance(shown, glm::dvec4(105, 16, 15, 1)) < 1e-12);
        piece.pivotLps = glm::dvec3(8, 10, 15);
        const glm::dvec4 fixed = shownFromTrue(piece, geometry) * glm::dvec4(8, 10, 15, 1);
        QVERIFY(glm::distance(fixed, glm::dvec4(108, 10, 15, 1)) < 1e-12);
        for (const glm::dvec3& turn : {glm::dvec3(10, -20, 30), glm::dvec3(0, 0, 179),
                 glm::dvec3(-120, 100, 5), glm::dvec3(1e-7, 0, 0), glm::dvec3(0)})
            QVERIFY(glm::distance(rotationDegrees(rotationMatrix(turn)), turn) < 1e-9);
    }

    /// Files of a time that knew neither bookmarks nor deleted segments keep their hashes.
    void theHashedStateSaysNoMoreThanItMust()
    {
        Document document = initialDocument({});
        QCOMPARE(stateOf(document),
            QByteArray("{\"growths\":[{\"generation\":0,\"plane\":0}],"
                       "\"layers\":[{\"id\":1,\"muted\":false,\"name\":\"Sculpt 1\"}],"
                       "\"segments\":[]}"));
        QVERIFY(applyToDocument(segment("Skull"), document));
        const QByteArray one = stateOf(document);
        QVERIFY(!one.contains("last") && !one.contains("bookmarks") && !one.contains("piece"));
        QVERIFY(applyToDocument(segment("Brain"), document));
        QVERIFY(applyToDocument(RemoveSegment{.segment = 2}, document));
        QVERIFY(stateOf(document).contains("\"lastLabel\":2"));
        // A greater label that is present says the same.
        QVERIFY(applyToDocument(segment("Third"), document));
        QVERIFY(!stateOf(document).contains("last"));
        QVERIFY(applyToDocument(RemoveSegment{.segment = 1}, document));
        QVERIFY(!stateOf(document).contains("last"));

        QVERIFY(applyToDocument(bookmark("Front"), document));
        QVERIFY(stateOf(document).contains(
            "\"bookmarks\":[{\"crosshairLps\":[1.5,-2,3],\"eyeLps\":[0,-400,10],\"heightMm\":250,"
            "\"id\":1,\"name\":\"Front\",\"targetLps\":[0,0,10],\"up\":[0,0,1]}]"));
        QVERIFY(applyToDocument(RemoveBookmark{.bookmark = 1}, document));
        QVERIFY(stateOf(document).contains("\"lastBookmark\":1"));
        QVERIFY(!stateOf(document).contains("bookmarks"));
    }

    void partsAreTold()
    {
        using What = DocumentChange::What;
        QVERIFY(changedPart(RemoveSegment{}) == What::Segments);
        QVERIFY(changedPart(MoveLayer{}) == What::Layers);
        QVERIFY(changedPart(AddBookmark{}) == What::Bookmarks);
        QVERIFY(changedPart(SendPiecesHome{}) == What::Pieces);
        QVERIFY(!changedPart(test::drillWith({})) && !changedPart(RevertRows{}));
        QVERIFY(changesDocumentOnly(ChangeLayer{}) && changesDocumentOnly(RemoveBookmark{}));
        QVERIFY(!changesDocumentOnly(RemoveSegment{})
            && !changesDocumentOnly(test::growBetween(0.0, 1.0)));
    }
};

BURIN_TEST(DocumentEditsTest)

} // namespace documentEditsTest

#include "DocumentEditsTest.moc"
