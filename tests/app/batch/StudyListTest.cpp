// SPDX-License-Identifier: Apache-2.0
#include "app/batch/StudyList.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace studyListTest {

using app::BatchStudy;
using core::Result;

/// Lists of studies, as people and programs write them, and whatever else has their ending.
class StudyListTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    Result<std::vector<BatchStudy>> read(const char* name, const QByteArray& text) const
    {
        QFile file(m_folder.filePath(QLatin1String(name)));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write %s", name);
        file.close();
        return app::readStudyList(file.fileName());
    }

    static void make(const QDir& folder, const QStringList& names);
    /// FILE=NAME of each.
    [[nodiscard]] static QStringList namesOf(const Result<std::vector<BatchStudy>>& studies);

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void numbersAreNumbers();
    void namesOfDigitsAreTexts();
    void theTableKeepsItsName();
    void whatLiesBesideStudiesIsNone();
    void whatSaysThatItIsDicomIsOne();
    void documentsAreNoArchives();
    void resultsAreNoStudies();
    void anythingIsReadOrRefused_data();
    void anythingIsReadOrRefused();
};

void StudyListTest::numbersAreNumbers()
{
    const auto studies = read("a.csv", "study,a,b,c,d,e\nx.nii,1.5,nan,-inf,1e400,infinity\n");
    QVERIFY(studies);
    QCOMPARE(studies->size(), std::size_t(1));
    const QJsonObject variables = studies->front().variables;
    QCOMPARE(variables[QStringLiteral("a")], QJsonValue(1.5));
    // A recipe could not hold them as numbers.
    for (const auto& [name, word] :
        {std::pair("b", "nan"), {"c", "-inf"}, {"d", "1e400"}, {"e", "infinity"}})
        QCOMPARE(variables[QLatin1String(name)], QJsonValue(QLatin1String(word)));
}

/// Only as a text they stay what they are. Any cell is also kept as it was written.
void StudyListTest::namesOfDigitsAreTexts()
{
    const auto studies =
        read("a.csv", "study,a,b,c,d,e,f,g\nx.nii,0012,0,0.5,-0.5,1.50,1234567890123456,4711\n");
    QVERIFY(studies);
    const BatchStudy& study = studies->front();
    const std::pair<const char*, QJsonValue> rows[] = {{"a", QStringLiteral("0012")}, {"b", 0.0},
        {"c", 0.5}, {"d", -0.5}, {"e", 1.5}, {"f", QStringLiteral("1234567890123456")},
        {"g", 4711.0}};
    for (const auto& [name, value] : rows)
        QCOMPARE(study.variables[QLatin1String(name)], value);
    QCOMPARE(study.cells[QStringLiteral("e")], QStringLiteral("1.50"));
    QVERIFY(!study.cells.contains(QStringLiteral("study")));
}

void StudyListTest::theTableKeepsItsName()
{
    const auto refused = read("a.csv", "study,name\nx.nii,results.csv\n");
    QVERIFY(!refused);
    QVERIFY2(refused.error().arguments.value(1).startsWith(QStringLiteral("line 2: the name")),
        qPrintable(refused.error().arguments.value(1)));
}

/// Files, and folders where a name ends in a slash.
void StudyListTest::make(const QDir& folder, const QStringList& names)
{
    for (const QString& name : names) {
        const QString path = folder.filePath(name);
        QVERIFY(QDir().mkpath(name.endsWith(u'/') ? path : QFileInfo(path).path()));
        QFile file(path);
        if (!name.endsWith(u'/'))
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write("any") == 3);
    }
}

QStringList StudyListTest::namesOf(const Result<std::vector<BatchStudy>>& studies)
{
    QStringList names;
    for (const BatchStudy& study : studies.value_or(std::vector<BatchStudy>()))
        names += QFileInfo(study.path).fileName() + u'=' + study.name;
    return names;
}

void StudyListTest::whatLiesBesideStudiesIsNone()
{
    const QTemporaryDir folder;
    make(QDir(folder.path()),
        {QStringLiteral("a.nii.gz"), QStringLiteral("a.json"), QStringLiteral("a.bval"),
            QStringLiteral("b.mhd"), QStringLiteral("b.raw"), QStringLiteral("c.nhdr"),
            QStringLiteral("c.raw.gz"), QStringLiteral("c.png"), QStringLiteral("ct/"),
            QStringLiteral("image"), QStringLiteral("readme.txt"), QStringLiteral("studies.csv")});
    const QStringList expected{QStringLiteral("a.nii.gz=a"), QStringLiteral("b.mhd=b"),
        QStringLiteral("c.nhdr=c"), QStringLiteral("ct=ct"), QStringLiteral("image=image")};
    QStringList leftOut;
    QCOMPARE(namesOf(app::readStudyList(folder.path(), {}, &leftOut)), expected);
    QCOMPARE(leftOut,
        (QStringList{QStringLiteral("a.bval"), QStringLiteral("a.json"), QStringLiteral("b.raw"),
            QStringLiteral("c.png"), QStringLiteral("c.raw.gz"), QStringLiteral("readme.txt"),
            QStringLiteral("studies.csv")}));

    // Two volumes of one name are told apart by a list, not by a column that no folder has.
    make(QDir(folder.path()), {QStringLiteral("a.nrrd")});
    const auto refused = app::readStudyList(folder.path());
    QVERIFY(!refused);
    const QString why = refused.error().arguments.value(1);
    QVERIFY2(why.contains(QStringLiteral("a list of them")), qPrintable(why));
}

/// Of a name that a companion might have, and of that of a volume: nothing is left out in silence.
void StudyListTest::whatSaysThatItIsDicomIsOne()
{
    const QTemporaryDir folder;
    const QDir here(folder.path());
    make(here, {QStringLiteral("a.nii"), QStringLiteral("b.raw"), QStringLiteral("c.raw")});
    const auto write = [&here](const char* name) {
        QFile file(here.filePath(QLatin1String(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray(128, '\0') + "DICM and more");
    };
    write("c.raw");
    QStringList leftOut;
    QCOMPARE(namesOf(app::readStudyList(here.path(), {}, &leftOut)),
        (QStringList{QStringLiteral("a.nii=a"), QStringLiteral("c.raw=c")}));
    QCOMPARE(leftOut, QStringList{QStringLiteral("b.raw")});
    write("a.dcm");
    const auto refused = app::readStudyList(here.path());
    QVERIFY(!refused);
    const QString why = refused.error().arguments.value(1);
    QVERIFY2(why.contains(QStringLiteral("a.dcm has the name 'a' too")), qPrintable(why));
}

/// Many programs keep their documents as zip: beside a volume they are no second study.
void StudyListTest::documentsAreNoArchives()
{
    const QTemporaryDir folder;
    const QDir here(folder.path());
    make(here, {QStringLiteral("a.nii")});
    for (const char* name : {"a.docx", "b.ZIP"}) {
        QFile file(here.filePath(QLatin1String(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("PK\x03\x04 and more");
    }
    QStringList leftOut;
    QCOMPARE(namesOf(app::readStudyList(here.path(), {}, &leftOut)),
        (QStringList{QStringLiteral("a.nii=a"), QStringLiteral("b.ZIP=b")}));
    QCOMPARE(leftOut, QStringList{QStringLiteral("a.docx")});
}

void StudyListTest::resultsAreNoStudies()
{
    const QTemporaryDir folder;
    const QDir here(folder.path());
    make(here, {QStringLiteral("a.nii"), QStringLiteral("b/1.dcm"), QStringLiteral("out/it/x")});
    const QStringList both{QStringLiteral("a.nii=a"), QStringLiteral("b=b")};
    for (const char* into : {"out", "out/it", "out/it/new", "./out/"})
        QCOMPARE(
            namesOf(app::readStudyList(folder.path(), here.filePath(QLatin1String(into)))), both);
    const QStringList all = both + QStringList{QStringLiteral("out=out")};
    QCOMPARE(
        namesOf(app::readStudyList(folder.path(), here.filePath(QStringLiteral("other")))), all);
    // Results right beside the studies: each has the name of its own.
    make(here, {QStringLiteral("a/lock"), QStringLiteral("a/record.json")});
    QCOMPARE(namesOf(app::readStudyList(folder.path(), folder.path())), all);
}

void StudyListTest::anythingIsReadOrRefused_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("table") << QByteArray("a.csv")
                           << QByteArray("\xef\xbb\xbfstudy,name,session,series,segment,mm\r\n"
                                         "ct/1,one,one.burin,,\"a \"\"b\"\"\",1.5\r\n"
                                         "ct/2,two,,1.2.3,c,-2e3\r\n");
    QTest::newRow("with tabs") << QByteArray("a.tsv")
                               << QByteArray("study\tname\tspacing\n../a.tif\tone\t1x1x2\n"
                                             "/data/b\ttwo\t\n");
    QTest::newRow("JSON") << QByteArray("a.json")
                          << QByteArray("[\"ct/1\", {\"study\": \"ct/2\", \"name\": \"two\","
                                        " \"threshold\": 3e2, \"keep\": true}]");
}

/// With bytes that are changed, taken out and put in: what is read has the form that a batch relies
/// on.
void StudyListTest::anythingIsReadOrRefused()
{
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, text);
    QVERIFY(read(name.constData(), text));
    const QByteArray likely("\",\n\r\t{}[]:\\/.0e-\0\xff", 18);
    test::Random random(17);
    int sound = 0;
    const int often = test::longRun() ? 20'000 : 400;
    for (int i = 0; i < often; ++i) {
        QByteArray changed = text;
        for (int k = test::randomInt(random, 1, 4); k > 0; --k) {
            const int at = test::randomInt(random, 0, int(changed.size()) - 1);
            const char byte = likely[test::randomInt(random, 0, int(likely.size()) - 1)];
            switch (test::randomInt(random, 0, 3)) {
            case 0:
                changed[at] = byte;
                break;
            case 1:
                changed.insert(at, byte);
                break;
            case 2:
                changed.remove(at, test::randomInt(random, 1, 3));
                break;
            default:
                changed.insert(at, changed.mid(test::randomInt(random, 0, at), 20));
            }
        }
        const auto studies = read(name.constData(), changed);
        if (!studies) {
            QVERIFY(!studies.error().arguments.isEmpty());
            continue;
        }
        ++sound;
        QSet<QString> names;
        for (const BatchStudy& study : *studies) {
            const QByteArray shown = changed.toPercentEncoding();
            QVERIFY2(QDir::isAbsolutePath(study.path), shown.constData());
            for (const QString& word : {study.name, study.session}) {
                QVERIFY2(!word.isEmpty() && word.size() <= 100 && !word.startsWith(u'.')
                        && !word.contains(u'/') && !word.contains(QChar::Null),
                    shown.constData());
            }
            QVERIFY2(study.session.endsWith(QLatin1String(".burin")), shown.constData());
            QVERIFY2(!names.contains(study.name), shown.constData());
            names.insert(study.name);
            for (const QJsonValue value : study.variables) {
                QVERIFY2(value.isString() || value.isBool()
                        || (value.isDouble() && std::isfinite(value.toDouble())),
                    shown.constData());
            }
        }
    }
    QVERIFY2(sound > often / 50, qPrintable(QString::number(sound)));
}

BURIN_TEST(StudyListTest)

} // namespace studyListTest

#include "StudyListTest.moc"
