// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/ToolMasks.h"
#include "core/edits/EditJson.h"
#include "core/edits/EditTask.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/ToolMask.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QJsonDocument>
#include <QtTest>

#include <cmath>

namespace toolMasksTest {

using namespace core;
using Kind = ToolMask::Kind;

namespace {

constexpr int pitch = 65536 / 4; ///< a quarter of a millimetre

ToolMask shape(Kind kind, double widthMm, double heightMm, double degrees = 0.0)
{
    ToolMask made;
    made.kind = kind;
    made.widthMm = widthMm;
    made.heightMm = heightMm;
    made.rotationDegrees = degrees;
    return made;
}

OutlineRaster raster(const ToolMask& made)
{
    const auto mask = maskOf(outlineMm(made, 0.25), pitch, glm::dvec2(0.5), QStringLiteral("mask"));
    return mask ? *mask : OutlineRaster{};
}

double areaMm2(const ToolMask& made)
{
    return double(raster(made).area()) / 256.0 / 16.0;
}

QJsonValue parsed(const QByteArray& mask)
{
    return QJsonDocument::fromJson(
        QByteArray("{'edit':'drill','view':{'eyeLps':[0,-200,0],'targetLps':[0,0,0],'up':[0,0,1],"
                   "'heightMm':80},'mask':")
            .append(mask)
            .append(",'depthMm':6,'surface':{'threshold':250},'samples':[[0,0,1,0]]}")
            .replace('\'', '"'))
        .object();
}

} // namespace

class ToolMasksTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void shapesHaveTheirArea()
    {
        for (const double degrees : {0.0, 17.0, 45.0, 90.0, -200.0}) {
            QVERIFY(std::abs(areaMm2(shape(Kind::Square, 12, 0, degrees)) - 144.0) < 0.3);
            QVERIFY(std::abs(areaMm2(shape(Kind::Rectangle, 20, 7, degrees)) - 140.0) < 0.3);
            QVERIFY(std::abs(areaMm2(shape(Kind::Ellipse, 20, 8, degrees)) - M_PI * 40.0) < 0.3);
            ToolMask rounded = shape(Kind::Rounded, 20, 8, degrees);
            rounded.cornerMm = 3.0;
            QVERIFY(std::abs(areaMm2(rounded) - (160.0 - (4.0 - M_PI) * 9.0)) < 0.3);
            rounded.cornerMm = 100.0; // no more than fits: a slot
            QVERIFY(std::abs(areaMm2(rounded) - (12.0 * 8.0 + M_PI * 16.0)) < 0.3);
        }
    }

    void turnsCounterClockwise()
    {
        // A long bar turned by 30° reaches up on the right.
        const OutlineRaster bar = raster(shape(Kind::Rectangle, 40, 2, 30));
        QCOMPARE(bar.at({int(std::round(15 * std::cos(M_PI / 6) * 4)), 15 * 2}), 256);
        QCOMPARE(bar.at({int(std::round(15 * std::cos(M_PI / 6) * 4)), -15 * 2}), 0);
        // A quarter turn is exact.
        const OutlineRaster upright = raster(shape(Kind::Ellipse, 9, 5, 90));
        const OutlineRaster lying = raster(shape(Kind::Ellipse, 9, 5));
        for (int b = -25; b <= 25; ++b) {
            for (int a = -25; a <= 25; ++a)
                QVERIFY(std::abs(upright.at({a, b}) - lying.at({b, a})) <= 1);
        }
        // It stands in the middle of its element.
        for (int b = -25; b <= 25; ++b) {
            for (int a = -25; a <= 25; ++a)
                QVERIFY(std::abs(lying.at({a, b}) - lying.at({-a, -b})) <= 1);
        }
    }

    void reachIsTheFarthestCorner()
    {
        QCOMPARE(reachMm(shape(Kind::Rectangle, 6, 8, 12)), 5.0);
        QCOMPARE(reachMm(shape(Kind::Ellipse, 6, 8)), 4.0);
        ToolMask polygon;
        polygon.polygonMm = {{{0, 0}, {3, -4}, {1, 1}}};
        QCOMPARE(reachMm(polygon), 5.0);
    }

    void isWrittenAsItIsRead_data()
    {
        QTest::addColumn<QByteArray>("mask");
        for (const char* mask : {"{'shape':'circle','radiusMm':8,'softnessMm':1.5}",
                 "{'shape':'square','sideMm':8,'rotationDegrees':30,'softnessMm':0}",
                 "{'shape':'ellipse','widthMm':8,'heightMm':3,'rotationDegrees':0,'softnessMm':0}",
                 "{'shape':'rectangle','widthMm':8,'heightMm':3,'rotationDegrees':-45,'softnessMm':"
                 "0}",
                 "{'shape':'rounded','widthMm':8,'heightMm':3,'cornerMm':1,'rotationDegrees':0,'"
                 "softnessMm':0}",
                 "{'polygonMm':[[0,0],[3,0],[0,3]],'softnessMm':2}"})
            QTest::newRow(mask) << QByteArray(mask);
    }
    void isWrittenAsItIsRead()
    {
        QFETCH(QByteArray, mask);
        const QJsonValue json = parsed(mask);
        const Result<Edit> edit = editFromJson(json);
        QVERIFY2(edit, edit ? "" : qPrintable(edit.error().arguments.join(u' ')));
        QCOMPARE(editToJson(*edit)[QLatin1String("mask")], json[QLatin1String("mask")]);
        QVERIFY(engineEditOf(*edit, initialDocument(test::smallStudy().volume)));
    }

    void isRefused_data()
    {
        QTest::addColumn<QByteArray>("mask");
        QTest::addColumn<QString>("field");
        QTest::newRow("no shape") << QByteArray("{'radiusMm':8}") << "drill.mask.shape";
        QTest::newRow("star") << QByteArray("{'shape':'star'}") << "drill.mask.shape";
        QTest::newRow("no radius") << QByteArray("{'shape':'circle'}") << "drill.mask.radiusMm";
        QTest::newRow("zero radius")
            << QByteArray("{'shape':'circle','radiusMm':0}") << "drill.mask.radiusMm";
        QTest::newRow("a circle has no side")
            << QByteArray("{'shape':'circle','radiusMm':2,'sideMm':2}") << "drill.mask.sideMm";
        QTest::newRow("both") << QByteArray("{'shape':'circle','polygonMm':[[0,0],[9,0],[0,9]]}")
                              << "drill.mask.shape";
        QTest::newRow("two points")
            << QByteArray("{'polygonMm':[[0,0],[9,0]]}") << "drill.mask.polygonMm";
        QTest::newRow("far off") << QByteArray("{'polygonMm':[[0,0],[9,0],[0,900]]}")
                                 << "drill.mask.polygonMm";
        QTest::newRow("no point") << QByteArray("{'polygonMm':[[0,0],[9,0],[0]]}")
                                  << "drill.mask.polygonMm";
    }
    void isRefused()
    {
        QFETCH(QByteArray, mask);
        QFETCH(QString, field);
        const Result<Edit> edit = editFromJson(parsed(mask));
        QVERIFY(!edit);
        QCOMPARE(edit.error().code, ErrorCode::InvalidField);
        QCOMPARE(edit.error().arguments.value(0), field);
    }

    void tinyOnesAreRefused()
    {
        const Document document = initialDocument(test::smallStudy().volume);
        const auto cutWith = [&document](const std::vector<glm::dvec2>& polygonMm) {
            return engineEditOf(
                test::drillWith({.mask = ToolMask{.polygonMm = polygonMm}}, test::drillAt(0)),
                document);
        };
        const Result<EngineEdit> cut = cutWith({{0, 0}, {0.2, 0}, {0.1, 0.1}});
        QVERIFY(!cut);
        QCOMPARE(cut.error().arguments.value(0), QStringLiteral("drill.mask"));
        QVERIFY(cut.error().arguments.value(1).contains(QStringLiteral("too small")));
        QVERIFY(!cutWith({{0, 0}, {20, 20}, {10, 10}})); // there and back
    }
};

BURIN_PLAIN_TEST(ToolMasksTest)

} // namespace toolMasksTest

#include "ToolMasksTest.moc"
