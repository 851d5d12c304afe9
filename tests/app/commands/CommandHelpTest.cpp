// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"
#include "tests/support/servers/BurinProgram.h"

#include <QProcess>
#include <QRegularExpression>
#include <QTest>

#include <csignal>
#include <set>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace commandHelpTest {

/// What each verb says of itself: what every option of its line in the overview means.
class CommandHelpTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void verbs_data();
    void verbs();
    void usageHasEveryOption_data() { verbs_data(); }
    void usageHasEveryOption();
    void overviewIsAskedFor();
    void anUnknownVerbIsOneLine();
    void wordsAreUnderstood_data();
    void wordsAreUnderstood();
    void outputThatIsLostIsAFailure_data();
    void outputThatIsLostIsAFailure();
    void whoClosesThePipeHasHadEnough();

private:
    [[nodiscard]] static std::set<QString> optionsIn(const QString& text)
    {
        static const QRegularExpression option(QStringLiteral("--([a-z-]+)"));
        std::set<QString> options;
        for (auto match = option.globalMatch(text); match.hasNext();)
            options.insert(match.next().captured(1));
        return options;
    }
};

void CommandHelpTest::verbs_data()
{
    QTest::addColumn<QString>("verb");
    QTest::addColumn<QString>("usage");
    const test::Outcome overview = test::burin({QStringLiteral("--help")});
    QCOMPARE(overview.status, 0);
    static const QRegularExpression line(
        QStringLiteral("^  burin (\\w+)(.*)$"), QRegularExpression::MultilineOption);
    for (auto match = line.globalMatch(QString::fromUtf8(overview.output)); match.hasNext();) {
        const QRegularExpressionMatch found = match.next();
        QTest::addRow("%s", qPrintable(found.captured(1)))
            << found.captured(1) << found.captured(2);
    }
}

void CommandHelpTest::verbs()
{
    QFETCH(QString, verb);
    QFETCH(QString, usage);
    const test::Outcome help = test::burin({verb, QStringLiteral("--help")});
    const QString text = QString::fromUtf8(help.output);
    QCOMPARE(help.status, 0);
    QVERIFY(help.complaint.isEmpty());
    QVERIFY2(text.startsWith(QStringLiteral("Usage: burin %1 ").arg(verb)), qPrintable(text));
    std::set<QString> said = optionsIn(text.mid(text.indexOf(QLatin1String("Options:"))));
    QVERIFY(said.erase(QStringLiteral("help")) == 1);
    for (const QString& option : optionsIn(usage))
        QVERIFY2(said.count(option) == 1, qPrintable(option));
}

/// Its line in the overview; what all that talk to a PACS take stands with `echo`.
void CommandHelpTest::usageHasEveryOption()
{
    QFETCH(QString, verb);
    QFETCH(QString, usage);
    const auto helpOf = [](const QString& of) {
        return QString::fromUtf8(test::burin({of, QStringLiteral("--help")}).output);
    };
    std::set<QString> told = optionsIn(usage);
    told.insert(QStringLiteral("help"));
    const std::set<QString> talks{QStringLiteral("echo"), QStringLiteral("find"),
        QStringLiteral("get"), QStringLiteral("send")};
    if (talks.count(verb) == 1)
        told.merge(optionsIn(helpOf(QStringLiteral("echo"))));
    const QString text = helpOf(verb);
    for (const QString& option : optionsIn(text.mid(text.indexOf(QLatin1String("Options:")))))
        QVERIFY2(told.count(option) == 1, qPrintable(option));
}

void CommandHelpTest::overviewIsAskedFor()
{
    const QByteArray overview = test::burin({QStringLiteral("--help")}).output;
    QVERIFY(overview.contains("burin run RECIPE.json"));
    for (const QStringList& words :
        {QStringList(), QStringList(QStringLiteral("help")), QStringList(QStringLiteral("-h"))}) {
        const test::Outcome outcome = test::burin(words);
        QCOMPARE(outcome.status, 0);
        QCOMPARE(outcome.output, overview);
    }
}

/// Behind all verbs with all their options nobody would see it.
void CommandHelpTest::anUnknownVerbIsOneLine()
{
    const test::Outcome outcome = test::burin({QStringLiteral("ifno"), QStringLiteral("x")});
    QCOMPARE(outcome.status, 2);
    QVERIFY(outcome.output.isEmpty());
    QCOMPARE(outcome.complaint, QStringLiteral("burin: unknown command 'ifno' (burin --help)\n"));
}

void CommandHelpTest::wordsAreUnderstood_data()
{
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QString>("complaint");
    const auto row = [](const char* words, const char* complaint) {
        QTest::newRow(words) << QString::fromLatin1(words).split(QLatin1Char(' '))
                             << QString::fromLatin1(complaint);
    };
    row("edits --shiny", "burin edits: unknown option --shiny");
    row("edits --json --json", "burin edits: --json is given twice");
    row("edits --json=yes", "burin edits: ");
    row("info x --series", "burin info: --series needs a value");
    row("info x --series=", "burin info: --series needs a value");
    row("info x --series a --series b", "burin info: --series is given twice");
    row("demo", "burin demo: it needs one folder");
    row("demo a b", "burin demo: it needs one folder");
    row("history a b", "burin history: it needs one session file");
    row("history -- --json a", "burin history: it needs one session file");
    row("history a.burin --report=a.pdf --json",
        "burin history: --json, --as-recipe, --report and --deidentified exclude each other");
    row("history a.burin --report a.pdf --deidentified b.burin",
        "burin history: --json, --as-recipe, --report and --deidentified exclude each other");
    row("run r.json -with-nothing", "burin run: unknown option -with-nothing");
    row("replay a.burin --fill -1000", "burin replay: --verify or --export is missing");
}

void CommandHelpTest::wordsAreUnderstood()
{
    QFETCH(QStringList, words);
    QFETCH(QString, complaint);
    const test::Outcome outcome = test::burin(words);
    QCOMPARE(outcome.status, 2);
    QVERIFY2(outcome.complaint.startsWith(complaint), qPrintable(outcome.complaint));
    QVERIFY2(outcome.complaint.contains(QStringLiteral("(burin %1 --help)").arg(words.first())),
        qPrintable(outcome.complaint));
}

void CommandHelpTest::outputThatIsLostIsAFailure_data()
{
    QTest::addColumn<QStringList>("words");
    QTest::newRow("edits") << QStringList{QStringLiteral("edits"), QStringLiteral("--json")};
    QTest::newRow("version") << QStringList{QStringLiteral("--version")};
    QTest::newRow("help") << QStringList{QStringLiteral("--help")};
}

/// As into a file on a disk that is full: nobody should take half a table for the whole.
void CommandHelpTest::outputThatIsLostIsAFailure()
{
    QFETCH(QStringList, words);
    for (const auto& [place, status] : {std::pair("/dev/full", 1), std::pair("/dev/null", 0)}) {
        QProcess process;
        process.setStandardOutputFile(QLatin1String(place));
        process.start(QStringLiteral(BURIN_PROGRAM), words);
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), status);
        QCOMPARE(
            process.readAllStandardError().contains("not all that it printed could be written"),
            status == 1);
    }
}

/// As `head` does, under a program that ignores the signal which ends others then.
void CommandHelpTest::whoClosesThePipeHasHadEnough()
{
    int ends[2] = {};
    QVERIFY(::pipe2(ends, O_CLOEXEC) == 0);
    ::close(ends[0]);
    QProcess process;
    process.setChildProcessModifier([output = ends[1]] {
        std::signal(SIGPIPE, SIG_IGN);
        ::dup2(output, STDOUT_FILENO);
    });
    process.start(
        QStringLiteral(BURIN_PROGRAM), {QStringLiteral("edits"), QStringLiteral("--json")});
    const bool isOver = process.waitForFinished();
    ::close(ends[1]);
    QVERIFY(isOver);
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 0);
    QCOMPARE(process.readAllStandardError(), QByteArray());
}

BURIN_TEST(CommandHelpTest)

} // namespace commandHelpTest

#include "CommandHelpTest.moc"
