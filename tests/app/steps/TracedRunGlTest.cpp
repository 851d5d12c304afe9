// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/program/TraceEvents.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QFile>
#include <QTest>

#include <set>
#include <vector>

namespace tracedRunGlTest {

using test::burin;
using test::key;
using test::Outcome;
using test::TraceEvent;

/// `--trace FILE.json` of verbs without a window.
class TracedRunGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

    [[nodiscard]] QString strokesAndGrowths() const
    {
        return recipe("recipe.json", {{key("edits"), test::toJson(test::manyEdits())}});
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(prepareStudy()); }
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    /// The engine's commands and the kernels that they ran, at the same steps with the same hashes.
    void tellsOfCommandsAndKernels()
    {
        const QString edits = strokesAndGrowths();
        const Outcome plain = run(edits, "plain.burin");
        QVERIFY2(plain.status == 0, qPrintable(plain.complaint));
        const Outcome traced = run(edits, "traced.burin", {key("--trace"), path("run.json")});
        QVERIFY2(traced.status == 0, qPrintable(traced.complaint));
        QCOMPARE(hashes("traced.burin"), hashes("plain.burin"));
        QVERIFY(!lastHash("traced.burin").isEmpty());

        const std::vector<TraceEvent> events = test::traceEvents(test::bytesOf(path("run.json")));
        QVERIFY(!events.empty());
        QVERIFY2(test::overlapIn(events).isEmpty(), qPrintable(test::overlapIn(events)));
        std::set<QString> commands;
        std::set<QString> edited;
        std::set<QString> kernels;
        for (const TraceEvent& event : events) {
            QVERIFY(event.begin >= 0 && event.end >= event.begin);
            if (event.category == QLatin1String("engine")
                && event.name.startsWith(QLatin1String("core::"))) {
                commands.insert(event.name);
                QVERIFY(event.waitedMicroseconds >= 0);
                if (event.name == QLatin1String("core::BeginEdit"))
                    edited.insert(event.detail);
            }
            // A kernel is called after its file.
            if (event.category == QLatin1String("gpu") && event.name.contains(u'/')) {
                kernels.insert(event.name);
                const QString file = QStringLiteral(BURIN_SOURCE_DIR "/gpu/") + event.name;
                QVERIFY2(QFile::exists(file), qPrintable(file));
            }
        }
        for (const char* known : {"core::BeginEdit", "core::ExtendEdit", "core::EndEdit"})
            QVERIFY2(commands.count(QLatin1String(known)) == 1, known);
        for (const char* known : {"core::DrillCut", "core::GrowBurst"})
            QVERIFY2(edited.count(QLatin1String(known)) == 1, known);
        QVERIFY(kernels.size() > 3);
        QVERIFY(test::timeIn(events, "gpu", "kernels/") > 0);
        QVERIFY(test::timeIn(events, "engine", "open volume") > 0);
    }

    void replayIsTracedToo()
    {
        const Outcome made = run(strokesAndGrowths(), "a.burin");
        QVERIFY2(made.status == 0, qPrintable(made.complaint));
        const Outcome replayed = burin({key("replay"), path("a.burin"), key("--verify"),
            key("--study"), study(), key("--trace"), path("replay.json")});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
        const std::vector<TraceEvent> events =
            test::traceEvents(test::bytesOf(path("replay.json")));
        QVERIFY(test::timeIn(events, "engine", "core::EndEdit") > 0);
        QVERIFY(test::timeIn(events, "gpu") > 0);
    }

    /// Nothing is done whose trace could not be written.
    void aFileThatIsThereStays()
    {
        QFile there(path("there.json"));
        QVERIFY(there.open(QIODevice::WriteOnly));
        there.write("mine");
        there.close();
        const Outcome refused =
            run(strokesAndGrowths(), "a.burin", {key("--trace"), path("there.json")});
        QCOMPARE(refused.status, 1);
        QVERIFY2(refused.complaint.contains(key("there.json"))
                && refused.complaint.contains(key("new file"))
                && !refused.complaint.contains(key("--force")),
            qPrintable(refused.complaint));
        QCOMPARE(test::bytesOf(path("there.json")), QByteArray("mine"));
        QVERIFY(!QFile::exists(path("a.burin")));

        const Outcome wrong =
            burin({key("run"), key("--trace"), path("new.json"), path("none.json")});
        QCOMPARE(wrong.status, 2);
        QVERIFY(!QFile::exists(path("new.json")));
    }
};

BURIN_TEST(TracedRunGlTest)

} // namespace tracedRunGlTest

#include "TracedRunGlTest.moc"
