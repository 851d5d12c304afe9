// SPDX-License-Identifier: Apache-2.0
#include "core/export/CarvedVolume.h"

#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "ui/texts/ReportTexts.h"

#include <glm/gtc/matrix_transform.hpp>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cstring>
#include <set>

namespace carvedVolumeTest {

using namespace core;

namespace {

/// Half a ball, with a rim that is cut in part.
std::vector<std::uint8_t> cut(const glm::ivec3& size)
{
    std::vector<std::uint8_t> coverage;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const double r = glm::length(glm::dvec3(x - 6, y - 5, 2 * (z - 3)));
                coverage.push_back(r < 5.0 ? 255 : r < 6.0 ? 128 : r < 7.0 ? 127 : 0);
            }
    return coverage;
}

std::string text(DcmDataset& set, const DcmTagKey& tag)
{
    OFString value;
    set.findAndGetOFStringArray(tag, value);
    return {value.c_str()};
}

/// Stored values of a file that was written without compression.
std::vector<int> storedOf(DcmDataset& set)
{
    Uint16 bits = 0;
    Uint16 allocated = 0;
    Uint16 representation = 0;
    set.findAndGetUint16(DCM_BitsStored, bits);
    set.findAndGetUint16(DCM_BitsAllocated, allocated);
    set.findAndGetUint16(DCM_PixelRepresentation, representation);
    std::vector<int> values;
    unsigned long count = 0;
    if (allocated == 8) {
        const Uint8* bytes = nullptr;
        set.findAndGetUint8Array(DCM_PixelData, bytes, &count);
        values.assign(bytes, bytes + count);
    } else {
        const Uint16* words = nullptr;
        set.findAndGetUint16Array(DCM_PixelData, words, &count);
        values.assign(words, words + count);
    }
    for (int& value : values) {
        if (representation == 1 && (value >> (bits - 1) & 1) != 0)
            value -= 1 << bits;
    }
    return values;
}

QString messageOf(const Error& error)
{
    return error.arguments.join(QStringLiteral(" | "));
}

/// A NIfTI-1 file as its bytes say (nifti1.h), little endian, not compressed.
struct Nifti {
    QByteArray bytes;

    explicit Nifti(const QString& file)
    {
        QFile in(file);
        if (in.open(QIODevice::ReadOnly))
            bytes = in.readAll();
        bytes.append(QByteArray(352, 0));
    }
    template <class T> [[nodiscard]] T at(qsizetype offset) const
    {
        T value;
        std::memcpy(&value, bytes.constData() + offset, sizeof value);
        return value;
    }
    [[nodiscard]] int intent() const { return at<std::int16_t>(68); }
    [[nodiscard]] int type() const { return at<std::int16_t>(70); }
    template <class T> [[nodiscard]] T voxel(std::size_t i) const
    {
        return at<T>(qsizetype(at<float>(108)) + qsizetype(i * sizeof(T)));
    }
    [[nodiscard]] double srow(int row, int column) const
    {
        return at<float>(280 + 16 * row + 4 * column);
    }
};
constexpr int typeUInt8 = 2;
constexpr int typeInt16 = 4;
constexpr int typeFloat32 = 16;

struct Opened {
    QTemporaryDir folder;
    QStringList files; ///< slice by slice
    LoadedVolume study;
    std::vector<std::uint8_t> coverage;

    explicit Opened(const test::SyntheticSeries& series)
    {
        files = test::writeSeries(series, folder.filePath(QStringLiteral("study")));
        Result<LoadedVolume> loaded = loadVolume(folder.filePath(QStringLiteral("study")));
        if (!loaded)
            qFatal("%s", qPrintable(messageOf(loaded.error())));
        study = *std::move(loaded);
        coverage = cut(series.size);
    }
    [[nodiscard]] QString target(const char* name) const
    {
        return folder.filePath(QLatin1String(name));
    }
    [[nodiscard]] Result<ExportReport> write(
        const QString& file, std::optional<double> fill = {}) const
    {
        return exportCarvedVolume(study.volume,
            {.target = file,
                .force = false,
                .coverage = coverage,
                .codes = study.codes,
                .fill = fill},
            Progress());
    }
};

test::SyntheticSeries oblique()
{
    test::SyntheticSeries series;
    const glm::dmat3 turned(
        glm::rotate(glm::dmat4(1.0), 0.6, glm::normalize(glm::dvec3(1, 2, -0.5))));
    series.plane = {turned[0], turned[1]};
    series.step = turned[2] * 3.3;
    return series;
}

} // namespace

class CarvedVolumeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aSeriesIsItsSourceWithoutTheCut_data()
    {
        QTest::addColumn<QString>("kind");
        for (const char* kind :
            {"CT", "oblique MR, signed", "8 bits", "JPEG-LS", "RLE, other order"})
            QTest::newRow(kind) << QString(QLatin1String(kind));
    }
    void aSeriesIsItsSourceWithoutTheCut()
    {
        QFETCH(QString, kind);
        test::SyntheticSeries series;
        double slope = 1.0;
        double intercept = -1024.0;
        if (kind.startsWith(QLatin1String("oblique"))) {
            series = oblique();
            series.modality = QStringLiteral("MR");
            series.layout.isSigned = true;
            series.layout.bitsStored = 16;
            series.layout.highBit = 15;
            slope = 0.5;
            intercept = 3.0;
            series.stored = [](const glm::ivec3& at) { return at.x * 31 - at.y * 47 + at.z - 300; };
        } else if (kind.startsWith(QLatin1String("8"))) {
            series.layout.bitsAllocated = series.layout.bitsStored = 8;
            series.layout.highBit = 7;
            series.stored = [](const glm::ivec3& at) { return (at.x * 7 + at.y + at.z) & 255; };
        } else if (kind.startsWith(QLatin1String("JPEG"))) {
            series.transferSyntaxUid = QStringLiteral("1.2.840.10008.1.2.4.80");
        } else if (kind.startsWith(QLatin1String("RLE"))) {
            series.transferSyntaxUid = QStringLiteral("1.2.840.10008.1.2.5");
            series.dirtySpareBits = false;
        }
        series.slope = [slope](int) { return slope; };
        series.intercept = [intercept](int) { return intercept; };
        const Opened opened(series);
        const QString folder = opened.target("carved");
        const Result<ExportReport> report = opened.write(folder);
        QVERIFY2(report, qPrintable(report ? QString() : messageOf(report.error())));
        QCOMPARE(report->checked.size(), 2);

        const double fill = opened.study.volume.minimum;
        std::set<std::string> instances;
        std::set<std::string> seriesUids;
        int filled = 0;
        for (int k = 0; k < series.size.z; ++k) {
            DcmFileFormat source;
            DcmFileFormat made;
            QVERIFY(source.loadFile(qPrintable(opened.files[k])).good());
            QVERIFY(made.loadFile(qPrintable(QStringLiteral("%1/IM%2.dcm")
                                                 .arg(folder)
                                                 .arg(k + 1, 4, 10, QLatin1Char('0'))))
                        .good());
            DcmDataset& before = *source.getDataset();
            DcmDataset& after = *made.getDataset();
            for (const DcmTagKey& kept :
                {DCM_PatientName, DCM_PatientID, DCM_StudyInstanceUID, DCM_FrameOfReferenceUID,
                    DCM_SOPClassUID, DCM_ImagePositionPatient, DCM_ImageOrientationPatient,
                    DCM_PixelSpacing, DCM_RescaleSlope, DCM_RescaleIntercept, DCM_Rows, DCM_Columns,
                    DCM_BitsStored, DCM_PixelRepresentation, DCM_Modality})
                QCOMPARE(text(after, kept), text(before, kept));
            instances.insert(text(before, DCM_SOPInstanceUID));
            instances.insert(text(after, DCM_SOPInstanceUID));
            seriesUids.insert(text(after, DCM_SeriesInstanceUID));
            QVERIFY(text(after, DCM_SeriesInstanceUID) != text(before, DCM_SeriesInstanceUID));
            QVERIFY(text(after, DCM_ImageType).rfind("DERIVED\\SECONDARY", 0) == 0);
            QVERIFY(text(after, DCM_SeriesDescription).find("CARVED") != std::string::npos);
            QVERIFY(text(after, DCM_DerivationDescription)
                        .find(QByteArray::number(fill, 'g', 12).toStdString())
                != std::string::npos);
            DcmItem* reference = nullptr;
            QVERIFY(after.findAndGetSequenceItem(DCM_SourceImageSequence, reference).good());
            OFString named;
            reference->findAndGetOFString(DCM_ReferencedSOPInstanceUID, named);
            QCOMPARE(std::string(named.c_str()), text(before, DCM_SOPInstanceUID));

            const std::vector<int> stored = storedOf(after);
            std::size_t i = 0;
            for (int y = 0; y < series.size.y; ++y) {
                for (int x = 0; x < series.size.x; ++x, ++i) {
                    const std::size_t voxel = i
                        + std::size_t(k) * std::size_t(series.size.x) * std::size_t(series.size.y);
                    if (opened.coverage[voxel] >= 128) {
                        QCOMPARE(stored[i] * slope + intercept, fill);
                        ++filled;
                    } else {
                        QCOMPARE(stored[i], series.stored({x, y, k}));
                    }
                }
            }
        }
        QCOMPARE(instances.size(), std::size_t(2 * series.size.z));
        QCOMPARE(seriesUids.size(), std::size_t(1));
        QVERIFY(filled > 100);
    }

    void niftiHoldsTheSame_data()
    {
        QTest::addColumn<double>("slope");
        QTest::addColumn<int>("type");
        QTest::newRow("whole numbers") << 1.0 << typeInt16;
        QTest::newRow("others") << 0.37 << typeFloat32;
    }
    void niftiHoldsTheSame()
    {
        QFETCH(double, slope);
        QFETCH(int, type);
        test::SyntheticSeries series = oblique();
        series.slope = [slope](int) { return slope; };
        const Opened opened(series);
        const QString file = opened.target("carved.nii");
        const Result<ExportReport> report = opened.write(file, -2000.0);
        QVERIFY2(report, qPrintable(report ? QString() : messageOf(report.error())));
        const Nifti image(file);
        QCOMPARE(image.type(), type);
        std::size_t i = 0;
        for (int z = 0; z < series.size.z; ++z) {
            for (int y = 0; y < series.size.y; ++y) {
                for (int x = 0; x < series.size.x; ++x, ++i) {
                    const double found = type == typeInt16 ? double(image.voxel<std::int16_t>(i))
                                                           : double(image.voxel<float>(i));
                    const double wanted =
                        opened.coverage[i] >= 128 ? -2000.0 : series.value({x, y, z});
                    QCOMPARE(float(found), float(wanted));
                }
            }
        }
        const glm::dvec3 lps = opened.study.volume.geometry.toWorld({5.0, 4.0, 3.0});
        for (int row = 0; row < 3; ++row) {
            const double ras = 5.0 * image.srow(row, 0) + 4.0 * image.srow(row, 1)
                + 3.0 * image.srow(row, 2) + image.srow(row, 3);
            QVERIFY(std::abs(ras - (row < 2 ? -lps[row] : lps[row])) < 1e-3);
        }
    }

    void coverageIsWrittenAsItIs()
    {
        const Opened opened(oblique());
        const QString file = opened.target("coverage.nii");
        const Result<ExportReport> report = exportCoverage(opened.study.volume,
            {.file = file,
                .force = false,
                .layer = QStringLiteral("Approach"),
                .coverage = opened.coverage},
            Progress());
        QVERIFY2(report, qPrintable(report ? QString() : messageOf(report.error())));
        const Nifti image(file);
        QCOMPARE(image.type(), typeUInt8);
        QCOMPARE(image.intent(), 0); // no labels
        for (std::size_t i = 0; i < opened.coverage.size(); ++i)
            QCOMPARE(image.voxel<std::uint8_t>(i), opened.coverage[i]);
    }

    /// NIfTI has one step for all slices, also for what is no mask.
    void unevenSlices()
    {
        test::SyntheticSeries series;
        for (int k = 0; k < series.size.z; ++k)
            series.positions.emplace_back(0.0, 0.0, 2.5 * k);
        series.positions[3].z += 0.1;
        const auto coverage = [](const Opened& opened) {
            return exportCoverage(opened.study.volume,
                {.file = opened.target("coverage.nii"),
                    .force = false,
                    .layer = QStringLiteral("Approach"),
                    .coverage = opened.coverage},
                Progress());
        };
        const Opened little(series);
        for (const Result<ExportReport>& report :
            {coverage(little), little.write(little.target("carved.nii"))}) {
            QVERIFY2(report, qPrintable(report ? QString() : messageOf(report.error())));
            const QString cautions = ui::reportTexts(report->cautions).join(u' ');
            QVERIFY2(cautions.contains(QStringLiteral("0.1")), qPrintable(cautions));
        }
        series.positions.back().z += 5.0;
        const Opened much(series);
        for (const Result<ExportReport>& report :
            {coverage(much), much.write(much.target("carved.nii"))}) {
            QVERIFY(!report);
            QCOMPARE(report.error().code, ErrorCode::UnsupportedFormat);
            QVERIFY2(report.error().arguments.value(1).contains(QStringLiteral("stray from it")),
                qPrintable(messageOf(report.error())));
        }
        QVERIFY(!QFile::exists(much.target("coverage.nii")));
        QVERIFY(!QFile::exists(much.target("carved.nii")));
        QVERIFY(much.write(much.target("carved")));
    }

    /// What cannot be exact is refused, and nothing is left behind.
    void refusals()
    {
        test::SyntheticSeries series;
        Opened opened(series);
        const auto refused = [&](const QString& file, std::optional<double> fill, ErrorCode code) {
            const QStringList before =
                QDir(opened.folder.path()).entryList(QDir::AllEntries | QDir::Hidden);
            const Result<ExportReport> report = opened.write(file, fill);
            QVERIFY(!report);
            QCOMPARE(report.error().code, code);
            QCOMPARE(QDir(opened.folder.path()).entryList(QDir::AllEntries | QDir::Hidden), before);
        };
        // 12 bits from −1024 on: neither below, nor between two values.
        refused(opened.target("a"), -1025.0, ErrorCode::UnsupportedFormat);
        refused(opened.target("a"), -1000.5, ErrorCode::UnsupportedFormat);
        refused(opened.target("a"), 3072.0, ErrorCode::UnsupportedFormat);
        refused(opened.target("study"), {}, ErrorCode::FileExists);
        QVERIFY(QDir(opened.folder.path()).mkdir(QStringLiteral("empty")));
        QVERIFY(opened.write(opened.target("empty"), -1024.0)); // an empty folder gives way
        refused(opened.target("empty"), {}, ErrorCode::FileExists);
        refused(opened.target("no/such/folder"), {}, ErrorCode::FileUnwritable);
        std::fill(opened.coverage.begin(), opened.coverage.end(), std::uint8_t(127));
        refused(opened.target("b.nii"), {}, ErrorCode::NothingToExport);
        opened.coverage[7] = 128;
        opened.study.volume.sources[1].file = opened.study.volume.sources[0].file;
        refused(opened.target("b"), {}, ErrorCode::UnsupportedFormat);
        opened.study.volume.sourceFormat = QStringLiteral("NIfTI");
        refused(opened.target("b"), {}, ErrorCode::UnsupportedFormat);
    }

    /// Their values can be none of a series that is written with 16 bits.
    void pixelsOf32BitsAreRefusedInWords()
    {
        test::SyntheticSeries series;
        series.adjust = [&](DcmDataset& set, int) {
            const std::vector<Uint16> words(
                2 * std::size_t(series.size.x) * std::size_t(series.size.y), 3);
            set.putAndInsertUint16(DCM_BitsAllocated, 32);
            set.putAndInsertUint16Array(DCM_PixelData, words.data(), words.size());
        };
        const Opened opened(series);
        const Result<ExportReport> report = opened.write(opened.target("a"));
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::UnsupportedFormat);
        QVERIFY2(report.error().arguments.value(1).contains(QStringLiteral("more than 16 bits")),
            qPrintable(messageOf(report.error())));
    }

    /// Each slice has a scale of its own: the fill value must be one of all of them.
    void slicesOfDifferentScale()
    {
        test::SyntheticSeries series;
        series.modality = QStringLiteral("PT");
        series.slope = [](int k) { return 0.5 + 0.25 * k; };
        series.intercept = [](int) { return 0.0; };
        const Opened opened(series);
        QVERIFY(opened.write(opened.target("zero"), 0.0));
        const Result<ExportReport> odd = opened.write(opened.target("odd"), 0.5);
        QVERIFY(!odd);
        QVERIFY2(odd.error().arguments.value(1).contains(QStringLiteral("fill value")),
            qPrintable(messageOf(odd.error())));
    }

    /// The check finds what a writer might do wrong: a study whose values are others.
    void aWrongVoxelIsFound()
    {
        Opened opened(test::SyntheticSeries{});
        opened.study.codes.back() ^= 1;
        const Result<ExportReport> report = opened.write(opened.target("carved"));
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::ExportMismatch);
        QVERIFY(!QDir(opened.target("carved")).exists());
    }
};

BURIN_TEST(CarvedVolumeTest)

} // namespace carvedVolumeTest

#include "CarvedVolumeTest.moc"
