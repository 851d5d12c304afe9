// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/SrTree.h"
#include "core/export/common/ExportMask.h"
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/series/VerifyResult.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <utility>

namespace reportUnitsTest {

using namespace core;

namespace {

/// A study with a segment of two voxels.
struct Study {
    QTemporaryDir folder;
    LoadedVolume loaded;
    std::vector<std::uint8_t> labels;
    std::vector<LabelPlaneView> planes;

    explicit Study(const test::SyntheticSeries& series)
    {
        test::writeSeries(series, folder.filePath(QStringLiteral("study")));
        Result<LoadedVolume> read = loadVolume(folder.filePath(QStringLiteral("study")));
        if (!read)
            qFatal("%s", qPrintable(read.error().arguments.join(u' ')));
        loaded = *std::move(read);
        labels.assign(loaded.codes.size(), 0);
        labels[100] = labels[101] = 1;
        planes = {{.plane = 0, .labels = labels}};
    }
    [[nodiscard]] QString file(const char* name) const
    {
        return folder.filePath(QLatin1String(name));
    }
    [[nodiscard]] Result<ExportReport> written(ExportFormat format, const char* name,
        const QString& called = QStringLiteral("Lesion")) const
    {
        Segment segment;
        segment.label = 1;
        segment.name = called;
        segment.code = {.scheme = QStringLiteral("SCT"),
            .value = QStringLiteral("52988006"),
            .meaning = QStringLiteral("Lesion")};
        return exportMask(loaded.volume,
            {.format = format,
                .file = file(name),
                .segments = {segment},
                .planes = planes,
                .codes = loaded.codes},
            {});
    }
};

QString codeIn(DcmItem& item, const DcmTagKey& sequence)
{
    DcmItem* code = nullptr;
    OFString value;
    if (item.findAndGetSequenceItem(sequence, code).bad()
        || code->findAndGetOFString(DCM_CodeValue, value).bad())
        return {};
    return QString::fromLatin1(value.c_str());
}

/// "126401 in g/ml{SUVbw}" of each number below, from the top to the end.
void addNumbers(DcmItem& item, QStringList& found)
{
    DcmSequenceOfItems* content = nullptr;
    if (item.findAndGetSequence(DCM_ContentSequence, content).bad())
        return;
    for (unsigned long i = 0; i < content->card(); ++i) {
        DcmItem& child = *content->getItem(i);
        DcmItem* measured = nullptr;
        if (child.findAndGetSequenceItem(DCM_MeasuredValueSequence, measured).good())
            found += codeIn(child, DCM_ConceptNameCodeSequence) + QStringLiteral(" in ")
                + codeIn(*measured, DCM_MeasurementUnitsCodeSequence);
        addNumbers(child, found);
    }
}

QStringList numbersIn(const QString& file)
{
    DcmFileFormat format;
    QStringList found;
    if (format.loadFile(QFile::encodeName(file).constData()).good())
        addNumbers(*format.getDataset(), found);
    return found;
}

} // namespace

/// A report names units and quantities as they are, and no size that nobody measured.
class ReportUnitsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void uptake_data()
    {
        QTest::addColumn<QByteArray>("units");
        QTest::addColumn<QByteArray>("suvType");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* units, const char* suvType, const char* unit,
                             const char* expected) {
            QTest::addRow("%s %s", units, suvType)
                << QByteArray(units) << QByteArray(suvType) << QString::fromLatin1(unit)
                << QString::fromLatin1(expected);
        };
        row("GML", "", "SUVbw", "126401 in g/ml{SUVbw}");
        row("GML", "BW", "SUVbw", "126401 in g/ml{SUVbw}");
        row("GML", "LBM", "SUVlbm", "126402 in g/ml{SUVlbm}");
        row("GML", "LBMJAMES128", "SUVlbm", "126402 in g/ml{SUVlbm}");
        row("GML", "LBMJANMA", "SUVlbm", "126402 in g/ml{SUVlbm}");
        row("GML", "IBW", "SUVibw", "126404 in g/ml{SUVibw}");
        row("CM2ML", "BSA", "SUVbsa", "126403 in cm2/ml{SUVbsa}");
        // A surface that is no surface.
        row("GML", "BSA", "g/mL", "126400 in g/ml");
        row("BQML", "", "Bq/mL", "VALUE in Bq/ml");
        row("CNTS", "", "CNTS", "VALUE in {counts}");
        row("PROPCPS", "", "PROPCPS", "VALUE in {propcounts}/s");
        row("UMOLMINML", "", "UMOLMINML", "VALUE in umol/min/ml");
        row("1CM", "", "1CM", "VALUE in /cm");
        row("PCNT", "", "PCNT", "VALUE in %");
        row("FLOZ", "", "FLOZ", "VALUE in {FLOZ}");
        row("", "", "", "VALUE in 1");
    }

    void uptake()
    {
        QFETCH(QByteArray, units);
        QFETCH(QByteArray, suvType);
        QFETCH(QString, unit);
        QFETCH(QString, expected);
        test::SyntheticSeries series;
        series.modality = QStringLiteral("PT");
        series.adjust = [&](DcmDataset& set, int) {
            if (!units.isEmpty())
                set.putAndInsertString(DCM_Units, units.constData());
            if (!suvType.isEmpty())
                set.putAndInsertString(DCM_SUVType, suvType.constData());
        };
        const Study on(series);
        QCOMPARE(on.loaded.volume.unit, unit);
        const auto report = on.written(ExportFormat::Sr, "a.dcm");
        VERIFY_DONE(report);
        const QStringList numbers = numbersIn(on.file("a.dcm"));
        // Mean, deviation, minimum, maximum and median.
        QVERIFY2(numbers.count(expected) == 5, qPrintable(numbers.join(u'\n')));
    }

    /// Sessions of before hold "g/mL"; a unit may be anything.
    void unitsOfOldAndOfOthers()
    {
        QCOMPARE(unitCode(QStringLiteral("g/mL")).value, QStringLiteral("g/ml"));
        QCOMPARE(quantityOf(QStringLiteral("g/mL"), QStringLiteral("PT")).value,
            QStringLiteral("126400"));
        QCOMPARE(unitCode(QStringLiteral("HU")).value, QStringLiteral("[hnsf'U]"));
        QCOMPARE(
            quantityOf(QStringLiteral("HU"), QStringLiteral("CT")).value, QStringLiteral("112031"));
        QCOMPARE(unitCode(QStringLiteral("NONE")).value, QStringLiteral("1"));
        QCOMPARE(unitCode(QStringLiteral("a {b}\\c, long beyond all codes")).value,
            QStringLiteral("{abc,longbeyond}"));
        QCOMPARE(unitCode(QStringLiteral("a {b}\\c, long beyond all codes")).meaning,
            QStringLiteral("a {b}c, long beyond all codes"));
        QCOMPARE(unitCode(QStringLiteral("CM2ML")).value, QStringLiteral("cm2/ml"));
        QCOMPARE(unitCode(QStringLiteral("CPS")).value, QStringLiteral("{counts}/s"));
        QCOMPARE(unitCode(QStringLiteral("STDDEV")).value, QStringLiteral("{stddev}"));
        QCOMPARE(unitCode(QStringLiteral("µ")).value, QStringLiteral("1"));
    }

    /// A single image that does not say how thick it is counts voxels.
    void unknownThickness()
    {
        test::SyntheticSeries series;
        series.size.z = 1;
        series.adjust = [](DcmDataset& set, int) { set.findAndDeleteElement(DCM_SliceThickness); };
        const Study on(series);
        const auto report = on.written(ExportFormat::Sr, "a.dcm");
        VERIFY_DONE(report);
        const QStringList numbers = numbersIn(on.file("a.dcm"));
        QVERIFY2(numbers.contains(QStringLiteral("118565006 in {voxels}")),
            qPrintable(numbers.join(u'\n')));
        QCOMPARE(numbers.size(), 6); // beside it the five of the values
        const auto table = on.written(ExportFormat::Csv, "a.csv");
        VERIFY_DONE(table);
        const QList<QByteArray> lines = test::bytesOf(on.file("a.csv")).split('\n');
        const QList<QByteArray> names = lines.at(0).trimmed().split(',');
        const QList<QByteArray> cells = lines.at(1).trimmed().split(',');
        QCOMPARE(cells.size(), names.size());
        QCOMPARE(cells.at(names.indexOf("voxels")), QByteArray("2"));
        QVERIFY(!cells.at(names.indexOf("mean")).isEmpty());
        const auto json = on.written(ExportFormat::Json, "a.json");
        VERIFY_DONE(json);
        const QJsonObject entry = QJsonDocument::fromJson(test::bytesOf(on.file("a.json")))
                                      .object()[u"segments"]
                                      .toArray()
                                      .at(0)
                                      .toObject();
        QCOMPARE(entry[u"voxels"].toInt(), 2);
        for (const char* name :
            {"volumeMl", "surfaceMm2", "sphericity", "longestDiameterMm", "acrossDiameterMm"}) {
            QVERIFY2(cells.at(names.indexOf(name)).isEmpty(), name);
            QVERIFY2(!entry.contains(QLatin1String(name)), name);
        }
    }

    /// A spreadsheet would take them for formulas; the check knows them again.
    void namesThatBeginLikeFormulas()
    {
        const Study on{test::SyntheticSeries()};
        int count = 0;
        for (const auto& [name, cell] :
            {std::pair("=1+1", "'=1+1"), std::pair("-5 mm", "'-5 mm"), std::pair("'=1", "''=1"),
                std::pair("'quoted", "'quoted"), std::pair("''", "''"), std::pair("a=b", "a=b")}) {
            const QByteArray file = "n" + QByteArray::number(++count) + ".csv";
            const auto table = on.written(ExportFormat::Csv, file.constData(), QLatin1String(name));
            VERIFY_DONE(table);
            const QList<QByteArray> lines = test::bytesOf(on.file(file.constData())).split('\n');
            QCOMPARE(lines.at(1).split(',').at(1), QByteArray(cell));
        }
    }
};

BURIN_TEST(ReportUnitsTest)

} // namespace reportUnitsTest

#include "ReportUnitsTest.moc"
