// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/LabelReading.h"

#include "core/engine/EngineCommands.h"
#include "core/engine/EngineResult.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <vector>

namespace labelReadingTest {

using namespace core;

namespace {

constexpr int bricks = 2500; ///< in a row: several portions
constexpr glm::ivec3 size{bricks * BrickGrid::side, BrickGrid::side, BrickGrid::side};

/// An engine with a voxel of label 3 in each seventh brick.
struct Labelled {
    Labelled()
    {
        const std::vector<std::uint16_t> codes(std::size_t(size.x) * size.y * size.z, 0);
        if (!engine.openVolume(size, codes))
            qFatal("no volume");
        SwapBricks swap;
        for (std::uint32_t brick = 0; brick < bricks; brick += 7) {
            std::vector<std::uint8_t> bytes(BrickGrid::voxelsPerBrick, 0);
            bytes[brick % bytes.size()] = 3;
            swap.bricks.push_back(
                {.key = {Field::Labels, 0, brick}, .bytes = BrickBytes(std::move(bytes))});
        }
        engine.submit(std::move(swap));
        for (const EngineResult& result : answers()) {
            if (result.error)
                qFatal("no labels");
        }
    }
    [[nodiscard]] std::vector<EngineResult> answers()
    {
        engine.finish();
        return engine.collect();
    }

    reference::ReferenceEngine engine;
};

} // namespace

class LabelReadingTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void twoPortionsAreOnTheirWay()
    {
        Labelled labelled;
        LabelReading reading(size, 0);
        std::size_t most = 0;
        std::int64_t found = 0;
        while (reading.ask(labelled.engine)) {
            const std::vector<EngineResult> answers = labelled.answers();
            most = std::max(most, answers.size());
            for (const EngineResult& answer : answers) {
                QVERIFY(reading.awaits(answer.ticket));
                QVERIFY(reading.take(answer));
                QVERIFY(!reading.awaits(answer.ticket));
            }
        }
        QCOMPARE(most, std::size_t(2));
        QCOMPARE(reading.reader().voxelsOf(3), std::int64_t((bricks + 6) / 7));
        for (const std::uint8_t label : reading.reader().takeLabels())
            found += label == 3 ? 1 : 0;
        QCOMPARE(found, std::int64_t((bricks + 6) / 7));
    }

    /// Nobody else's answer is one of its own, and an error is told.
    void whatFailsIsTold()
    {
        Labelled labelled;
        LabelReading reading(size, 0);
        const Ticket other = labelled.engine.submit(ReadBricks{});
        QVERIFY(reading.ask(labelled.engine));
        QVERIFY(!reading.awaits(other));
        std::vector<EngineResult> answers = labelled.answers();
        QCOMPARE(answers.size(), std::size_t(3));
        answers[1].error = Error{ErrorCode::OutOfMemory, {}};
        const Result<void> taken = reading.take(answers[1]);
        QVERIFY(!taken && taken.error().code == ErrorCode::OutOfMemory);
        QVERIFY(reading.awaits(answers[2].ticket));
    }
};

BURIN_TEST(LabelReadingTest)

} // namespace labelReadingTest

#include "LabelReadingTest.moc"
