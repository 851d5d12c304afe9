// SPDX-License-Identifier: Apache-2.0
#include "core/titles/RowTitle.h"
#include "core/titles/TitleForms.h"
#include "core/titles/TitleJson.h"
#include "tests/support/program/TestProgram.h"

#include <QJsonDocument>
#include <QSet>
#include <QTest>

namespace rowTitleTest {

using namespace core;

namespace {

RowTitle count(RowTitleCode code, std::int64_t number)
{
    return {.code = code, .arguments = {TitleCount{number}}};
}

RowTitle named(RowTitleCode code, const char* name)
{
    return {.code = code, .arguments = {QString::fromUtf8(name)}};
}

RowTitle drilled()
{
    return {.code = RowTitleCode::Drill,
        .arguments = {inMm(6.24999)},
        .then = {count(RowTitleCode::Bricks, 214)}};
}

/// As deep as @p depth says.
RowTitle nested(int depth)
{
    RowTitle title = named(RowTitleCode::AddLayer, "a");
    for (int i = 1; i < depth; ++i)
        title = {.code = RowTitleCode::UndoOnly, .arguments = {asArgument(title)}};
    return title;
}

QJsonObject object(const char* json)
{
    return QJsonDocument::fromJson(QByteArray(json)).object();
}

} // namespace

/// What rows say as codes: the names that are made of them, and how files keep them.
class RowTitleTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyCodeHasAnIdOfItsOwn()
    {
        QSet<QString> ids;
        int codes = 0;
        for (; formOf(RowTitleCode(codes)).id; ++codes) {
            const TitleForm form = formOf(RowTitleCode(codes));
            ids.insert(QLatin1String(form.id));
            QVERIFY2(form.text, form.id);
            QCOMPARE(titleCodeFrom(QString::fromLatin1(form.id)), RowTitleCode(codes));
        }
        QCOMPARE(ids.size(), qsizetype(codes));
        QVERIFY(codes > int(RowTitleCode::TakeChunks));
        QVERIFY(!titleCodeFrom(QStringLiteral("somethingNewer")));
    }

    void namesAreMadeOfTitles_data()
    {
        QTest::addColumn<RowTitle>("title");
        QTest::addColumn<QString>("name");
        const auto row = [](const RowTitle& title, const char* name) {
            QTest::newRow(name) << title << QString::fromUtf8(name);
        };
        using Code = RowTitleCode;
        row(drilled(), "Drill 6.2 mm, 214 bricks");
        row(count(Code::Voxels, 1), "1 voxel");
        row(count(Code::Voxels, 0), "0 voxels");
        row(count(Code::VoxelsLost, 18204), "−18 204 voxels");
        row(count(Code::VoxelsGained, 1), "+1 voxel");
        row(count(Code::FlowIn, 1), "+1 voxels");
        row(count(Code::Vertices, 1), "1 vertex");
        row(count(Code::Vertices, 1234567), "1 234 567 vertices");
        row({.code = Code::FlowInAndOut, .arguments = {TitleCount{2104}, TitleCount{3}}},
            "+2 104 −3 voxels");
        row({.code = Code::GrowSegmentSteps,
                .arguments = {TitleCount{41}, QStringLiteral("Skull")},
                .then = {count(Code::VoxelsGained, 18204)}},
            "Grow 'Skull' 41 steps, +18 204 voxels");
        row({.code = Code::GrowSegmentsSteps, .arguments = {TitleCount{1}, TitleCount{2}}},
            "Grow 2 segments 1 step");
        row({.code = Code::Recover,
                .arguments = {asArgument({.code = Code::RangeInUnit,
                    .arguments = {TitleDigits{120.0}, TitleDigits{-0.25}, QStringLiteral("HU")}})}},
            "Recover 120 … -0.25 HU");
        row({.code = Code::GrowInterval,
                .arguments = {asArgument({.code = Code::Range,
                    .arguments = {TitleDigits{1234567.0}, TitleDigits{0.0}}})},
                .then = {{.code = Code::NoVoxel}}},
            "Grow 1.23457e+06 … 0, no voxel");
        row({.code = Code::SegmentSeen,
                .arguments = {QStringLiteral("A")},
                .then = {{.code = Code::WithinLimits}, count(Code::VoxelsGained, 3)}},
            "Segment what is seen as 'A', within limits, +3 voxels");
        row({.code = Code::MoveSeeds, .arguments = {TitleCount{1}, QStringLiteral("A")}},
            "Move 1 seed of 'A'");
        const RowTitle reasons{.code = Code::Reasons,
            .arguments = {std::vector<RowTitle>{
                {.code = Code::BelongTo, .arguments = {TitleCount{1}, QStringLiteral("A")}},
                count(Code::SeedsAlready, 3)}}};
        row({.code = Code::SeedStroke,
                .arguments = {QStringLiteral("B")},
                .then = {{.code = Code::VoxelsOfBecause,
                    .arguments = {TitleCount{5}, TitleCount{1}, asArgument(reasons)}}}},
            "Seed stroke for 'B', 1 of 5 voxels (1 belongs to 'A'; 3 are seeds already)");
        row({.code = Code::ReviseStroke,
                .arguments = {asArgument(headlineOf(drilled())),
                    asArgument({.code = Code::Changes,
                        .arguments = {std::vector<RowTitle>{
                            {.code = Code::RadiusTo, .arguments = {inMm(3.0), inMm(4.05)}},
                            {.code = Code::LayerTo,
                                .arguments = {TitleNumber{1}, TitleNumber{12345}}},
                            {.code = Code::ThroughGaps}}}})},
                .then = {count(Code::Voxels, 7)}},
            "Revise 'Drill 6.2 mm': radius 3.0 → 4.0 mm and layer 1 → 12345 and through gaps, "
            "7 voxels");
        row({.code = Code::UndoOnly, .arguments = {asArgument(headlineOf(drilled()))}},
            "Undo only 'Drill 6.2 mm'");
        row({.code = Code::RenameSegment,
                .arguments = {TitleNumber{1}, QStringLiteral("%2 %1 Bone")},
                .then = {{.code = Code::RecolourIt},
                    {.code = Code::CodeIt, .arguments = {QStringLiteral("Bone")}}}},
            "Rename segment 1 to '%2 %1 Bone', recolour it, code it as Bone");
        row({.code = Code::ImportMaskAs,
                .arguments = {TitleCount{2}, QStringLiteral("a.nrrd"), QStringLiteral("B")},
                .then = {{.code = Code::Millilitres,
                    .arguments = {TitleDecimal{.value = 0.25, .decimals = 3}}}}},
            "Import 2 segments of a.nrrd as 'B', 0.250 mL");
        row({.code = Code::PercentOff, .arguments = {TitleDecimal{.value = 0.7449, .decimals = 2}}},
            "0.74 % off");
        row({.code = Code::PercentOff, .arguments = {TitleDecimal{.value = 0.0, .decimals = 0}}},
            "0 % off");
        row({.code = Code::ZoomPiece,
                .arguments = {QStringLiteral("A"), TitleDigits{.value = 1.25, .digits = 3}}},
            "Zoom piece 'A' 1.25×");
        row({.code = Code::TurnPiece, .arguments = {QStringLiteral("A"), TitleNumber{90}}},
            "Turn piece 'A' 90°");
        row({.code = Code::Mark,
                .arguments = {asArgument({.code = Code::Green})},
                .then = {{.code = Code::MarkBrush, .arguments = {inMm(4.0)}},
                    count(Code::Vertices, 214)}},
            "Mark green, brush 4.0 mm, 214 vertices");
        row({.code = Code::MoveLayer, .arguments = {QStringLiteral("A"), TitleNumber{2}}},
            "Move layer 'A' to place 2");
        row(named(Code::StoredName, "Something of before"), "Something of before");
        row({}, "");
    }
    void namesAreMadeOfTitles()
    {
        QFETCH(const RowTitle, title);
        QFETCH(const QString, name);
        QCOMPARE(canonicalName(title), name);
        const QString text = titleText(title);
        QVERIFY(!text.isEmpty());
        QVERIFY(titleFromText(text, name) == title);
        QVERIFY(!titleFromText(text, name + u'.'));
    }

    void everyCodeComesBack()
    {
        for (int code = 0; formOf(RowTitleCode(code)).id; ++code) {
            RowTitle title{.code = RowTitleCode(code),
                .arguments = {TitleCount{2}, QStringLiteral("Jörg \"J\" ', %1"), inMm(0.1),
                    TitleDigits{1.0 / 3.0}, TitleNumber{-5}, asArgument(drilled())},
                .then = {count(RowTitleCode::Voxels, std::int64_t(1) << 60)}};
            const QString form = QString::fromUtf8(formOf(title.code).text);
            while (!title.arguments.empty()
                && !form.contains(QStringLiteral("%%1").arg(title.arguments.size())))
                title.arguments.pop_back();
            QVERIFY(titleFromText(titleText(title), canonicalName(title)) == title);
        }
    }

    void whatStandsInANameIsNoPlace()
    {
        QCOMPARE(canonicalName({.code = RowTitleCode::MergeLayers,
                     .arguments = {QStringLiteral("%2"), QStringLiteral("%1%2")}}),
            QStringLiteral("Merge layer '%2' into '%1%2'"));
        // Rows were named so from the start, and old ones must come out as they were.
        QCOMPARE(canonicalName({.code = RowTitleCode::MoveSegment,
                     .arguments = {QStringLiteral("A%1"), TitleNumber{3}}}),
            QStringLiteral("Move segment 'A3' to place %2"));
    }

    void headlinesLeaveOutWhatChanged()
    {
        QCOMPARE(canonicalName(headlineOf(drilled())), QStringLiteral("Drill 6.2 mm"));
        const RowTitle plain = named(RowTitleCode::AddLayer, "a, b");
        QVERIFY(headlineOf(plain) == plain);
    }

    void limitsHold()
    {
        QCOMPARE(depthOf(nested(3)), 3);
        QVERIFY(!titleText(nested(TitleLimits::depth)).isEmpty());
        QVERIFY(titleText(nested(TitleLimits::depth + 1)).isEmpty());
        QVERIFY(
            titleText(named(RowTitleCode::AddLayer, QByteArray(70000, 'a').constData())).isEmpty());
        RowTitle wide{.code = RowTitleCode::Reasons};
        wide.arguments.resize(TitleLimits::arguments + 1);
        QVERIFY(titleText(wide).isEmpty());
        RowTitle longOne{.code = RowTitleCode::Nothing};
        longOne.then.resize(TitleLimits::titles + 1);
        QVERIFY(titleText(longOne).isEmpty());
    }

    void whatIsNoTitleIsNotRead_data()
    {
        QTest::addColumn<QByteArray>("json");
        const auto row = [](const char* name, const char* json) {
            QTest::newRow(name) << QByteArray(json);
        };
        row("nothing", "");
        row("a list", "[]");
        row("no code", "{}");
        row("a code of a newer Burin", R"({"code":"somethingNewer"})");
        row("a code that is a number", R"({"code":3})");
        row("an argument that is nothing", R"({"code":"bricks","arguments":[null]})");
        row("an argument of no kind", R"({"code":"bricks","arguments":[{"weight":3}]})");
        row("half a voxel", R"({"code":"bricks","arguments":[{"count":0.5}]})");
        row("a count in words", R"({"code":"bricks","arguments":[{"count":"three"}]})");
        row("a thousand decimals",
            R"({"code":"drill","arguments":[{"decimal":1.5,"decimals":1000}]})");
        row("decimals below nothing",
            R"({"code":"drill","arguments":[{"decimal":1.5,"decimals":-1}]})");
        row("something newer inside", R"({"code":"undoOnly","arguments":[[{"code":"newer"}]]})");
        row("something newer behind", R"({"code":"drill","then":[{"code":"newer"}]})");
    }
    void whatIsNoTitleIsNotRead()
    {
        QFETCH(const QByteArray, json);
        QVERIFY(!titleFromJson(object(json.constData())));
        QVERIFY(!titleFromText(QString::fromUtf8(json), QString()));
    }

    /// It would go into copies and de-identified files unseen.
    void whatTheNameDoesNotShowIsNoTitle()
    {
        const RowTitle home{.code = RowTitleCode::SendPiecesHome};
        RowTitle more = home;
        more.arguments.emplace_back(QStringLiteral("Dr. Miller, ward 3"));
        QCOMPARE(canonicalName(more), canonicalName(home));
        QVERIFY(titleFromText(titleText(home), canonicalName(home)));
        QVERIFY(!titleFromText(titleText(more), canonicalName(more)));
        const RowTitle inside{
            .code = RowTitleCode::UndoOnly, .arguments = {asArgument(more)}, .then = {}};
        QVERIFY(!titleFromText(titleText(inside), canonicalName(inside)));
        const RowTitle behind{.code = RowTitleCode::SendPiecesHome, .then = {more}};
        QVERIFY(!titleFromText(titleText(behind), canonicalName(behind)));
    }

    /// "%1" 16 000 times, and as many letters for each of them: 256 million.
    void textsDoNotMultiply()
    {
        const QString places = QStringLiteral("%1").repeated(16000);
        const RowTitle title{.code = RowTitleCode::MoveSegment,
            .arguments = {places, QString(16000, QLatin1Char('a'))}};
        QVERIFY(!titleText(title).isEmpty());
        QVERIFY(canonicalName(title).size() < 100000);
    }

    void aDeepOneIsNotFollowed()
    {
        QByteArray json = R"({"code":"nothing"})";
        for (int i = 0; i < 400; ++i)
            json = R"({"code":"undoOnly","arguments":[[)" + json + "]]}";
        QVERIFY(!titleFromJson(object(json.constData())));
    }
};

BURIN_PLAIN_TEST(RowTitleTest)

} // namespace rowTitleTest

#include "RowTitleTest.moc"
