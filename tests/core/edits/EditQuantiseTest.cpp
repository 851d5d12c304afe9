// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditQuantise.h"
#include "core/edits/EditJson.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "tests/support/program/TestProgram.h"

#include <QJsonDocument>
#include <QTest>

#include <cmath>
#include <cstring>
#include <random>

namespace editQuantiseTest {

using namespace core;

namespace {

class RandomEdits {
public:
    explicit RandomEdits(unsigned seed)
        : m_engine(seed)
    {
    }
    double number(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(m_engine);
    }
    glm::dvec3 point() { return {number(-900, 900), number(-900, 900), number(-2000, 2000)}; }

    DrillStroke drill()
    {
        DrillStroke stroke;
        stroke.view = {.eyeLps = point(),
            .targetLps = point(),
            .up = point() / 2000.0,
            .heightMm = number(1, 900)};
        stroke.mask.radiusMm = number(0.1, 50);
        stroke.depthMm = number(0.1, 50);
        stroke.surfaceThreshold = number(-1024, 3000);
        double time = 0;
        for (int i = 0; i < 20; ++i) {
            time += number(0, 0.01);
            stroke.samples.push_back({.xMm = number(-200, 200),
                .yMm = number(-200, 200),
                .pressure = number(0, 1),
                .tSeconds = time});
        }
        return stroke;
    }
    SeedStroke seed()
    {
        SeedStroke stroke{.segment = 1, .pointsLps = {}};
        for (int i = 0; i < 20; ++i)
            stroke.pointsLps.push_back(point());
        return stroke;
    }
    GrowSteps grow() { return {.criteria = {.lower = number(-1e-3, 0), .upper = number(0, 1e6)}}; }

private:
    std::mt19937 m_engine;
};

bool onGrid(double value, double perUnit)
{
    return value == std::round(value * perUnit) / perUnit;
}

bool sameBits(double a, double b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

QByteArray text(const Edit& edit)
{
    return QJsonDocument(editToJson(edit)).toJson(QJsonDocument::Compact);
}

} // namespace

class EditQuantiseTest : public QObject {
    Q_OBJECT

private:
    const int m_rounds = qEnvironmentVariableIsSet("BURIN_LONG") ? 20000 : 500;

private Q_SLOTS:
    void numbersLieOnTheirGrids()
    {
        RandomEdits random(1);
        const DrillStroke before = random.drill();
        const auto after = quantised(before).get<DrillStroke>();
        QVERIFY(onGrid(after.view.eyeLps.x, 1024) && onGrid(after.view.targetLps.z, 1024));
        QVERIFY(onGrid(after.view.up.y, 1048576));
        QVERIFY(onGrid(after.mask.radiusMm, 1024) && onGrid(after.depthMm, 1024));
        QVERIFY(std::abs(after.mask.radiusMm - before.mask.radiusMm) <= 0.5 / 1024);
        for (std::size_t i = 0; i < after.samples.size(); ++i) {
            QVERIFY(onGrid(after.samples[i].xMm, 1024) && onGrid(after.samples[i].yMm, 1024));
            QVERIFY(onGrid(after.samples[i].pressure, 65535));
            QVERIFY(onGrid(after.samples[i].tSeconds, 10000));
            QVERIFY(
                std::abs(after.samples[i].pressure - before.samples[i].pressure) <= 0.5 / 65535);
        }
        QVERIFY(sameBits(after.surfaceThreshold, before.surfaceThreshold));
    }

    void roundingTwiceIsRoundingOnce()
    {
        RandomEdits random(2);
        for (int round = 0; round < m_rounds; ++round) {
            for (const Edit& edit :
                {Edit(random.drill()), Edit(random.seed()), Edit(random.grow())}) {
                const Edit once = quantised(edit);
                QCOMPARE(text(quantised(once)), text(once));
            }
        }
    }

    void jsonHoldsEveryBit()
    {
        RandomEdits random(3);
        for (int round = 0; round < m_rounds; ++round) {
            const auto stroke = quantised(random.drill()).get<DrillStroke>();
            const Result<Edit> read = editFromJson(QJsonDocument::fromJson(text(stroke)).object());
            QVERIFY(read);
            const auto& again = read->get<DrillStroke>();
            QVERIFY(sameBits(again.view.up.x, stroke.view.up.x));
            QVERIFY(sameBits(again.surfaceThreshold, stroke.surfaceThreshold));
            for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
                QVERIFY(sameBits(again.samples[i].xMm, stroke.samples[i].xMm));
                QVERIFY(sameBits(again.samples[i].pressure, stroke.samples[i].pressure));
                QVERIFY(sameBits(again.samples[i].tSeconds, stroke.samples[i].tSeconds));
            }
            const auto grow = quantised(random.grow()).get<GrowSteps>();
            const Result<Edit> readGrow =
                editFromJson(QJsonDocument::fromJson(text(grow)).object());
            QVERIFY(readGrow);
            QVERIFY(sameBits(readGrow->get<GrowSteps>().criteria.lower, grow.criteria.lower));
            QVERIFY(sameBits(readGrow->get<GrowSteps>().criteria.upper, grow.criteria.upper));
        }
    }

    void minusZeroIsZero()
    {
        const SeedStroke seed{.segment = 1, .pointsLps = {{-0.0, -1e-9, 0.0}}};
        QCOMPARE(
            text(quantised(seed)), text(SeedStroke{.segment = 1, .pointsLps = {{0.0, 0.0, 0.0}}}));
    }

    void theEndsOfARangeStayInside()
    {
        // A row is checked before it is rounded; one that leaves its range by that cannot be read.
        const QStringList shapes{QStringLiteral("circle"), QStringLiteral("ellipse"),
            QStringLiteral("square"), QStringLiteral("rectangle"), QStringLiteral("rounded")};
        for (const double side : {0.02, 400.0}) {
            for (int kind = 0; kind < shapes.size(); ++kind) {
                DrillStroke stroke = RandomEdits(5).drill();
                stroke.mask = {.kind = ToolMask::Kind(kind),
                    .radiusMm = side / 2.0,
                    .widthMm = side,
                    .heightMm = side,
                    .cornerMm = side,
                    .rotationDegrees = 360.0};
                QVERIFY2(editFromJson(editToJson(stroke)), qPrintable(shapes[kind]));
                const Result<Edit> read = editFromJson(editToJson(quantised(stroke)));
                QVERIFY2(read, qPrintable(shapes[kind]));
                QCOMPARE(text(*read), text(quantised(stroke)));
            }
        }
        for (const editFields::Number& range :
            {editSchema::millimetres, editSchema::drillRadius, editSchema::brushRadius,
                editSchema::drillDepth, editSchema::peelDepth, editSchema::maskSide}) {
            for (const double end : {range.minimum, range.maximum}) {
                QCOMPARE(range.check(range.rounded(end)), QString());
                QCOMPARE(range.rounded(range.rounded(end)), range.rounded(end));
            }
        }
    }

    void aPieceOfAPathIsRoundedLikeTheWhole()
    {
        RandomEdits random(4);
        const DrillStroke stroke = random.drill();
        DrillStroke pieced = quantised(stroke).get<DrillStroke>();
        pieced.samples = quantised(stroke.samples);
        QCOMPARE(text(pieced), text(quantised(stroke)));
    }
};

BURIN_TEST(EditQuantiseTest)

} // namespace editQuantiseTest

#include "EditQuantiseTest.moc"
