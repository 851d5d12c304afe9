// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/sessions/GoldenSessions.h"
#include "tests/support/series/SessionFiles.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

#include <array>

namespace houseGoldenGlTest {

using test::burin;
using test::key;
using test::Outcome;

/// What the command line answers about what tests/data/gold holds, and writes of it, on the GPU
/// engine: recipes, sessions recorded before, histories, exports.
class HouseGoldenGlTest : public QObject, test::CommandFixture {
    Q_OBJECT

    static void everyName()
    {
        QTest::addColumn<QString>("name");
        for (const QString& name : test::goldenNames())
            QTest::newRow(qUtf8Printable(name)) << name;
    }
    static QString gold(const QString& name) { return test::goldenFolder() + u'/' + name; }
    static constexpr std::array exported{"out.nii", "out.stl", "coverage.nii.gz"};
    /// The recipe, and behind it what is to be written of where it ends.
    QString withExports(const QString& name) const
    {
        QFile file(gold(name + key(".json")));
        if (!file.open(QIODevice::ReadOnly))
            qFatal("no %s", qUtf8Printable(file.fileName()));
        QJsonObject content = QJsonDocument::fromJson(file.readAll()).object();
        QJsonArray exports;
        for (const char* each : exported) {
            const QString format = QLatin1String(each).startsWith(key("coverage")) ? key("coverage")
                : QLatin1String(each).endsWith(key(".stl"))                        ? key("stl")
                                                                                   : key("nifti");
            QJsonObject entry{{key("format"), format}, {key("file"), path(each)}};
            if (format == key("coverage"))
                entry[key("layer")] = 1;
            else if (name == key("sculpt"))
                continue; // it has no segment
            exports.append(entry);
        }
        content[key("export")] = exports;
        // Masks that it takes in lie beside the original.
        static_cast<void>(QFile::copy(gold(key("mask.nii.gz")), path("mask.nii.gz")));
        return recipe("recipe.json", content);
    }
    /// One JSON object a line, without what depends on time and machine.
    static QString linesOf(const Outcome& outcome)
    {
        QString text;
        for (QJsonObject line : outcome.lines) {
            if (line.contains(key("export")) || line.contains(key("file")))
                continue; // names a place on this machine
            line.remove(key("ms"));
            text += QString::fromUtf8(QJsonDocument(line).toJson(QJsonDocument::Compact)) + u'\n';
        }
        return text;
    }

    QString m_golden;

private Q_SLOTS:
    void initTestCase()
    {
        m_golden = otherStudy("golden.nii.gz", test::goldenStudy());
        QVERIFY(!m_golden.isEmpty());
    }
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    void theProgramAnswersTheSame_data() { everyName(); }
    void theProgramAnswersTheSame()
    {
        QFETCH(const QString, name);
        const QString session = path("s.burin");
        const Outcome ran = burin(
            {key("run"), withExports(name), key("--study"), m_golden, key("--session"), session});
        QVERIFY2(ran.status == 0, qPrintable(ran.complaint));
        // The rows are those that the oracle recorded.
        QFile recorded(gold(name + key(".txt")));
        QVERIFY(recorded.open(QIODevice::ReadOnly));
        const QString rows = test::rowsOf(session);
        QVERIFY(!rows.isEmpty());
        QVERIFY2(QString::fromUtf8(recorded.readAll()).endsWith(u'\n' + rows), qPrintable(rows));

        QString answers = QStringLiteral("run\n") + linesOf(ran);
        const Outcome replayed = burin(
            {key("replay"), gold(name + key(".burin")), key("--verify"), key("--study"), m_golden});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
        answers += QStringLiteral("\nreplay --verify\n") + linesOf(replayed);
        const Outcome recipe = burin({key("history"), session, key("--as-recipe")});
        QVERIFY2(recipe.status == 0, qPrintable(recipe.complaint));
        const QJsonArray edits =
            QJsonDocument::fromJson(recipe.output).object().value(key("edits")).toArray();
        QVERIFY(!edits.isEmpty());
        answers += QStringLiteral("\nhistory --as-recipe\n");
        for (const QJsonValue& edit : edits)
            answers +=
                QString::fromUtf8(QJsonDocument(edit.toObject()).toJson(QJsonDocument::Compact))
                + u'\n';
        answers += QStringLiteral("\nexport\n");
        for (const char* file : exported)
            answers += QStringLiteral("%1 | %2\n")
                           .arg(QLatin1String(file), QLatin1String(test::fingerprint(path(file))));
        const QString difference = test::differenceFromGold(name + key(".answers.txt"), answers);
        QVERIFY2(difference.isEmpty(), qPrintable(difference));
    }
};

BURIN_TEST(HouseGoldenGlTest)

} // namespace houseGoldenGlTest

#include "HouseGoldenGlTest.moc"
