// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/MaskSelection.h"
#include "core/images/NaturalOrder.h"
#include "core/repair/SeriesFindings.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/ImageFiles.h"
#include "tests/support/series/OpenedVolume.h"
#include "tests/support/series/VolumeFiles.h"
#include "ui/texts/ProblemTexts.h"

#include <QDir>
#include <QTest>

#include <tiff.h>

namespace imageStackTest {

using core::LoadedVolume;
using core::Result;
using core::VolumeProblem;
using test::picture;
using test::pixelAt;
using test::png;
using test::TiffOptions;
using test::writeTiff;

namespace {

constexpr int columns = 21;
constexpr int rows = 18;
const QString spacing = QStringLiteral("+spacing=0.5x0.25x2");

/// The first voxel that is not pixelAt() with @p shift; empty: all are.
QString wrongVoxel(const LoadedVolume& loaded, int shift)
{
    const glm::ivec3 size = loaded.volume.geometry.size;
    std::size_t at = 0;
    for (int k = 0; k < size.z; ++k) {
        for (int row = 0; row < size.y; ++row) {
            for (int column = 0; column < size.x; ++column, ++at) {
                const double value = loaded.volume.encoding.value(loaded.codes[at]);
                if (std::abs(value - double(pixelAt(k, column, row) + shift)) > 1e-3)
                    return QStringLiteral("(%1, %2, %3): %4")
                        .arg(column)
                        .arg(row)
                        .arg(k)
                        .arg(value);
            }
        }
    }
    return {};
}

bool tells(const LoadedVolume& loaded, VolumeProblem::Kind kind, const char* text)
{
    return std::any_of(loaded.volume.problems.begin(), loaded.volume.problems.end(),
        [&](const VolumeProblem& problem) {
            return problem.kind == kind
                && ui::problemText(problem.said).contains(QLatin1String(text));
        });
}

} // namespace

/// Folders of PNG and TIFF pictures and TIFFs of several pages as volumes: values, order, place.
class ImageStackTest : public QObject, protected test::VolumeFiles {
    Q_OBJECT

private Q_SLOTS:
    void init() { makeFolder(); }

    void tiffForms_data();
    void tiffForms();
    void pngDepths();
    void placeOfVoxels();
    void spacingHasToBeGiven();
    void filesThatSayTheirSpacing_data();
    void filesThatSayTheirSpacing();
    void namesAreOrderedAsPeopleDo();
    void numbersThatAreMissing();
    void foldersAreVolumesOfTheirOwn();
    void besideOtherVolumesTheyAreNone();
    void whiteIsZero();
    void picturesThatDiffer_data();
    void picturesThatDiffer();
    void picturesThatAreNotRead_data();
    void picturesThatAreNotRead();

private:
    [[nodiscard]] QString folder() const { return m_folder->path(); }
    [[nodiscard]] QString path(const QString& name) const { return m_folder->filePath(name); }
    void putPng(const QString& name, int k)
    {
        put(name, png(picture<std::uint16_t>(k, columns, rows)));
    }
};

void ImageStackTest::tiffForms_data()
{
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("compression");
    QTest::addColumn<int>("predictor");
    QTest::addColumn<int>("tile");
    QTest::addColumn<bool>("bigEndian");
    QTest::addColumn<bool>("bigTiff");
    const std::array<const char*, 8> types{
        "uint8", "int8", "uint16", "int16", "uint32", "int32", "float", "double"};
    const std::array packings{std::pair("plain", COMPRESSION_NONE),
        std::pair("LZW", COMPRESSION_LZW), std::pair("deflate", COMPRESSION_ADOBE_DEFLATE),
        std::pair("PackBits", COMPRESSION_PACKBITS)};
    for (int type = 0; type < int(types.size()); ++type) {
        for (const auto& [name, compression] : packings) {
            const bool predicts =
                compression == COMPRESSION_LZW || compression == COMPRESSION_ADOBE_DEFLATE;
            for (const int predictor : {1, type < 6 ? 2 : 3}) {
                for (const int tile : {0, 16}) {
                    for (const bool bigEndian : {false, true}) {
                        if (predictor != 1 && !predicts)
                            continue;
                        QTest::addRow("%s, %s, predictor %d, %s, %s", types[std::size_t(type)],
                            name, predictor, tile != 0 ? "tiles" : "strips",
                            bigEndian ? "big endian" : "little endian")
                            << type << compression << predictor << tile << bigEndian
                            << (bigEndian && tile == 0);
                    }
                }
            }
        }
    }
}

void ImageStackTest::tiffForms()
{
    QFETCH(int, type);
    QFETCH(int, compression);
    QFETCH(int, predictor);
    QFETCH(int, tile);
    QFETCH(bool, bigEndian);
    QFETCH(bool, bigTiff);
    using Make = test::PictureBytes (*)(int, int, int);
    const std::array<Make, 8> makers{picture<std::uint8_t>, picture<std::int8_t>,
        picture<std::uint16_t>, picture<std::int16_t>, picture<std::uint32_t>,
        picture<std::int32_t>, picture<float>, picture<double>};
    std::vector<test::PictureBytes> pages;
    for (int k = 0; k < 3; ++k)
        pages.push_back(makers[std::size_t(type)](k, columns, rows));
    const QString file = path(QStringLiteral("stack.tif"));
    QVERIFY(writeTiff(file, pages,
        {.bigEndian = bigEndian,
            .bigTiff = bigTiff,
            .compression = compression,
            .predictor = predictor,
            .tile = tile}));
    const Result<LoadedVolume> loaded = core::loadVolume(file, spacing);
    QVERIFY2(loaded, qPrintable(loaded ? QString() : test::errorText(loaded.error())));
    QCOMPARE(loaded->volume.geometry.size, glm::ivec3(columns, rows, 3));
    QCOMPARE(wrongVoxel(*loaded, pages.front().sampleFormat == 1 ? 60 : 0), QString());
}

void ImageStackTest::pngDepths()
{
    for (const bool interlaced : {false, true}) {
        for (int k = 0; k < 3; ++k) {
            const QString number = QString::number(k);
            put(QStringLiteral("a%1.png").arg(number),
                png(picture<std::uint8_t>(k, columns, rows), 0, {}, interlaced));
        }
        const Result<LoadedVolume> bytes = core::loadVolume(folder(), spacing);
        QVERIFY2(bytes, qPrintable(bytes ? QString() : test::errorText(bytes.error())));
        QCOMPARE(wrongVoxel(*bytes, 60), QString());
        makeFolder();
        for (int k = 0; k < 3; ++k)
            put(QStringLiteral("a%1.png").arg(k),
                png(picture<std::uint16_t>(k, columns, rows), 0, {}, interlaced));
        const Result<LoadedVolume> words = core::loadVolume(folder(), spacing);
        QVERIFY2(words, qPrintable(words ? QString() : test::errorText(words.error())));
        QCOMPARE(wrongVoxel(*words, 60), QString());
        makeFolder();
    }
}

void ImageStackTest::placeOfVoxels()
{
    for (int k = 0; k < 4; ++k)
        putPng(QStringLiteral("s%1.png").arg(k), k);
    const Result<LoadedVolume> loaded = core::loadVolume(folder(), spacing);
    QVERIFY(loaded);
    const glm::dmat4 expected(glm::dvec4(0.5, 0, 0, 0), glm::dvec4(0, 0.25, 0, 0),
        glm::dvec4(0, 0, 2, 0), glm::dvec4(0, 0, 0, 1));
    QCOMPARE(loaded->volume.geometry.indexToWorld, expected);
    QCOMPARE(loaded->volume.repair, spacing.mid(1));
    QCOMPARE(loaded->volume.sourcePath, folder());
    QVERIFY(loaded->volume.sources.empty());
    QVERIFY(tells(*loaded, VolumeProblem::Kind::Other, "columns are taken to run to the left"));
    // Exports do not replace what was opened.
    put(QStringLiteral("note.txt"), "");
    QVERIFY(core::isSourceFile(loaded->volume, path(QStringLiteral("s1.png"))));
    QVERIFY(!core::isSourceFile(loaded->volume, path(QStringLiteral("note.txt"))));
    // The same lengths, said otherwise, are the same name.
    const Result<LoadedVolume> again =
        core::loadVolume(folder(), QStringLiteral("+spacing=5e-1x0.250x2.0"));
    QVERIFY(again);
    QCOMPARE(again->volume.repair, spacing.mid(1));
}

void ImageStackTest::spacingHasToBeGiven()
{
    putPng(QStringLiteral("1.png"), 0);
    putPng(QStringLiteral("2.png"), 1);
    const Result<core::Study> study = core::Study::scan(folder());
    QVERIFY(study);
    const core::SeriesEntry* entry = study->listing().lacksSpacing(QString());
    QVERIFY(entry != nullptr);
    QCOMPARE(entry->key, QDir(folder()).dirName());
    QVERIFY(study->listing().lacksSpacing(entry->key + spacing) == nullptr);
    const Result<LoadedVolume> without = study->load();
    QVERIFY(!without);
    QCOMPARE(without.error().code, core::ErrorCode::InvalidGeometry);
    QVERIFY(test::errorText(without.error()).contains(QLatin1String("--spacing")));
    for (const char* wrong : {"+spacing=1x1", "+spacing=1x1x0", "+spacing=1x1x-2", "+spacing=axbxc",
             "+spacing=1x1xnan", "+spacing=1x1x1e9", "+tilt", "+tilt,spacing=1x1x1"}) {
        const Result<LoadedVolume> loaded = study->load(QLatin1String(wrong));
        QVERIFY2(!loaded, wrong);
        QCOMPARE(loaded.error().code, core::ErrorCode::InvalidField);
    }
    QVERIFY(study->load(spacing));
    QVERIFY(study->load(entry->key + spacing));
}

void ImageStackTest::filesThatSayTheirSpacing_data()
{
    QTest::addColumn<QByteArray>("description");
    QTest::addColumn<double>("perUnit");
    QTest::addColumn<int>("unit");
    QTest::addColumn<double>("across");
    QTest::addColumn<double>("along");
    QTest::addRow("nothing") << QByteArray() << 0.0 << 2 << 0.0 << 0.0;
    QTest::addRow("per inch") << QByteArray() << 254.0 << 2 << 0.1 << 0.0;
    QTest::addRow("per centimetre") << QByteArray() << 40.0 << 3 << 0.25 << 0.0;
    QTest::addRow("no unit") << QByteArray() << 40.0 << 1 << 0.0 << 0.0;
    QTest::addRow("a screen's 72") << QByteArray() << 72.0 << 2 << 0.0 << 0.0;
    QTest::addRow("a screen's 96") << QByteArray() << 96.0 << 2 << 0.0 << 0.0;
    QTest::addRow("ImageJ, mm") << QByteArray("ImageJ=1.53\nimages=2\nslices=2\nunit=mm\n"
                                              "spacing=2.5\nloop=false\n")
                                << 4.0 << 1 << 0.25 << 2.5;
    QTest::addRow("ImageJ, microns")
        << QByteArray("ImageJ=1.53\nimages=2\nunit=micron\nspacing=300\n") << 0.01 << 1 << 0.1
        << 0.3;
    QTest::addRow("ImageJ, no spacing")
        << QByteArray("ImageJ=1.53\nimages=2\nunit=mm\n") << 2.0 << 1 << 0.5 << 0.0;
    QTest::addRow("ImageJ, pixels")
        << QByteArray("ImageJ=1.53\nimages=2\nunit=pixel\nspacing=3\n") << 2.0 << 1 << 0.0 << 0.0;
}

void ImageStackTest::filesThatSayTheirSpacing()
{
    QFETCH(QByteArray, description);
    QFETCH(double, perUnit);
    QFETCH(int, unit);
    QFETCH(double, across);
    QFETCH(double, along);
    const QString file = path(QStringLiteral("stack.tiff"));
    QVERIFY(writeTiff(file,
        {picture<std::uint8_t>(0, columns, rows), picture<std::uint8_t>(1, columns, rows)},
        {.columnsPerUnit = perUnit,
            .rowsPerUnit = perUnit / 2.0,
            .resolutionUnit = unit,
            .description = description}));
    const Result<core::Study> study = core::Study::scan(file);
    QVERIFY(study);
    const core::SeriesEntry& entry = study->listing().studies.front().series.front();
    QVERIFY(entry.saidSpacingMm.has_value());
    const glm::dvec3 expected(across, 2.0 * across, along);
    QVERIFY2(glm::length(*entry.saidSpacingMm - expected) < 1e-6,
        qPrintable(QStringLiteral("%1 %2 %3")
                       .arg(entry.saidSpacingMm->x)
                       .arg(entry.saidSpacingMm->y)
                       .arg(entry.saidSpacingMm->z)));
    const bool isWhole = across > 0.0 && along > 0.0;
    QCOMPARE(entry.needsSpacing(), !isWhole);
    const Result<LoadedVolume> loaded = study->load();
    QCOMPARE(loaded.has_value(), isWhole);
    if (isWhole) {
        QVERIFY(glm::length(loaded->volume.geometry.spacingMm() - expected) < 1e-6);
        QVERIFY(loaded->volume.repair.isEmpty());
    }
    // What is given holds.
    const Result<LoadedVolume> given = study->load(spacing);
    QVERIFY(given);
    QVERIFY(glm::length(given->volume.geometry.spacingMm() - glm::dvec3(0.5, 0.25, 2)) < 1e-12);
}

void ImageStackTest::namesAreOrderedAsPeopleDo()
{
    const QStringList inOrder{QStringLiteral("a1b2.png"), QStringLiteral("a1b10.png"),
        QStringLiteral("A2b1.png"), QStringLiteral("a010b1.png"), QStringLiteral("b.png"),
        QStringLiteral("slice2.png"), QStringLiteral("slice02.png.png"),
        QStringLiteral("slice10.png"), QStringLiteral("slice18446744073709551616.png"),
        QStringLiteral("slice18446744073709551617.png")};
    for (qsizetype i = 0; i < inOrder.size(); ++i) {
        QVERIFY(!core::comesBefore(inOrder[i], inOrder[i]));
        for (qsizetype j = i + 1; j < inOrder.size(); ++j) {
            QVERIFY2(core::comesBefore(inOrder[i], inOrder[j]), qPrintable(inOrder[j]));
            QVERIFY2(!core::comesBefore(inOrder[j], inOrder[i]), qPrintable(inOrder[j]));
        }
    }
    // Values tell the order: 12 slices written in another.
    for (const int k : {7, 11, 0, 3, 10, 1, 2, 9, 4, 8, 5, 6})
        putPng(QStringLiteral("slice%1.png").arg(k + 1), k);
    const Result<LoadedVolume> loaded = core::loadVolume(folder(), spacing);
    QVERIFY(loaded);
    QCOMPARE(loaded->volume.geometry.size.z, 12);
    QCOMPARE(wrongVoxel(*loaded, 60), QString());
    QVERIFY(!tells(*loaded, VolumeProblem::Kind::MissingSlices, ""));
}

void ImageStackTest::numbersThatAreMissing()
{
    int k = 0;
    for (const int number : {10, 12, 14, 20, 22})
        putPng(QStringLiteral("CT_%1.png").arg(number, 4, 10, QLatin1Char('0')), k++);
    const Result<LoadedVolume> loaded = core::loadVolume(folder(), spacing);
    QVERIFY(loaded);
    QVERIFY(tells(
        *loaded, VolumeProblem::Kind::MissingSlices, "2 between CT_0014.png and CT_0020.png"));
    QVERIFY(loaded->volume.needsCaution());
    // Where the pictures lie nothing is missing that could be filled.
    const Result<core::StudyListing> listing = core::scanStudies(folder());
    QVERIFY(listing);
    const core::SeriesEntry& entry = listing->studies.front().series.front();
    for (const core::SeriesFinding& finding : core::seriesFindings(*listing, entry)) {
        for (const core::RepairOffer& offer : finding.offers)
            QVERIFY2(!offer.repair.contains(QLatin1String("gap")), qPrintable(offer.repair));
    }
    // Names that are not numbered, or otherwise, say nothing.
    QVERIFY(core::numberGaps({QStringLiteral("a.png"), QStringLiteral("c.png")}).empty());
    QVERIFY(core::numberGaps({QStringLiteral("a1.png"), QStringLiteral("b9.png")}).empty());
    QVERIFY(core::numberGaps({QStringLiteral("a1"), QStringLiteral("a3"), QStringLiteral("a6")})
                .empty());
    QCOMPARE(
        core::numberGaps({QStringLiteral("a1"), QStringLiteral("a2"), QStringLiteral("a9")}).size(),
        std::size_t(1));
}

void ImageStackTest::foldersAreVolumesOfTheirOwn()
{
    for (const char* name : {"left", "right"}) {
        QVERIFY(QDir(folder()).mkdir(QLatin1String(name)));
        for (int k = 0; k < 2; ++k)
            putPng(QStringLiteral("%1/%2.png").arg(QLatin1String(name)).arg(k), k);
    }
    QVERIFY(writeTiff(path(QStringLiteral("left/pages.tif")),
        {picture<std::uint8_t>(0, 5, 4), picture<std::uint8_t>(1, 5, 4),
            picture<std::uint8_t>(2, 5, 4)}));
    const Result<core::Study> study = core::Study::scan(folder());
    QVERIFY(study);
    QStringList keys;
    for (const core::SeriesEntry& entry : study->listing().studies.front().series)
        keys += QStringLiteral("%1 %2").arg(entry.key).arg(entry.slices());
    keys.sort();
    QCOMPARE(keys,
        (QStringList{
            QStringLiteral("left 2"), QStringLiteral("pages.tif 3"), QStringLiteral("right 2")}));
    const Result<LoadedVolume> pages = study->load(QStringLiteral("pages.tif") + spacing);
    QVERIFY(pages);
    QCOMPARE(pages->volume.sourcePath, path(QStringLiteral("left/pages.tif")));
    QCOMPARE(wrongVoxel(*pages, 60), QString());
}

void ImageStackTest::besideOtherVolumesTheyAreNone()
{
    put(QStringLiteral("ct.mha"),
        "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\n"
        "ElementSpacing = 1 1 1\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nElementDataFile = LOCAL\n"
        "12345678");
    putPng(QStringLiteral("preview.png"), 0);
    const Result<core::Study> study = core::Study::scan(folder());
    QVERIFY(study);
    QCOMPARE(study->listing().studies.size(), std::size_t(1));
    QCOMPARE(study->listing().foreign.size(), std::size_t(1));
    QVERIFY(study->listing().foreign.front().kind.contains(QLatin1String("PNG")));
    QVERIFY(study->load());
}

void ImageStackTest::whiteIsZero()
{
    const QString file = path(QStringLiteral("one.tif"));
    QVERIFY(writeTiff(file, {picture<std::uint8_t>(0, columns, rows)}, {.photometric = 0}));
    const Result<LoadedVolume> loaded = core::loadVolume(file, spacing);
    QVERIFY(loaded);
    QVERIFY(loaded->volume.displayInverted);
    QCOMPARE(wrongVoxel(*loaded, 60), QString());
}

void ImageStackTest::picturesThatDiffer_data()
{
    QTest::addColumn<QByteArray>("second");
    QTest::addColumn<QString>("says");
    QTest::addRow("size") << png(picture<std::uint8_t>(1, columns, rows + 1))
                          << QStringLiteral("21 × 19 of 8 bits, but 1.png is 21 × 18 of 8 bits");
    QTest::addRow("depth") << png(picture<std::uint16_t>(1, columns, rows))
                           << QStringLiteral("21 × 18 of 16 bits, but 1.png");
    test::PictureBytes colours = picture<std::uint8_t>(1, columns * 3, rows);
    colours.columns = columns;
    QTest::addRow("colours") << png(colours, 2) << QStringLiteral("colours");
}

void ImageStackTest::picturesThatDiffer()
{
    QFETCH(QByteArray, second);
    QFETCH(QString, says);
    put(QStringLiteral("1.png"), png(picture<std::uint8_t>(0, columns, rows)));
    const QString file = put(QStringLiteral("2.png"), second);
    const Result<LoadedVolume> loaded = core::loadVolume(folder(), spacing);
    QVERIFY(!loaded);
    const QString text = test::errorText(loaded.error());
    QVERIFY2(text.contains(file) && text.contains(says), qPrintable(text));
}

void ImageStackTest::picturesThatAreNotRead_data()
{
    QTest::addColumn<int>("photometric");
    QTest::addColumn<int>("compression");
    QTest::addColumn<QByteArray>("description");
    QTest::addColumn<QString>("says");
    QTest::addRow("palette") << int(PHOTOMETRIC_PALETTE) << int(COMPRESSION_NONE) << QByteArray()
                             << QStringLiteral("palette");
    QTest::addRow("mask") << int(PHOTOMETRIC_MASK) << int(COMPRESSION_NONE) << QByteArray()
                          << QStringLiteral("colours");
    QTest::addRow("JPEG") << int(PHOTOMETRIC_MINISBLACK) << int(COMPRESSION_JPEG) << QByteArray()
                          << QStringLiteral("packed by method 7");
    QTest::addRow("channels") << int(PHOTOMETRIC_MINISBLACK) << int(COMPRESSION_NONE)
                              << QByteArray("ImageJ=1.53\nimages=2\nchannels=2\n")
                              << QStringLiteral("several channels");
    QTest::addRow("beyond 4 GB") << int(PHOTOMETRIC_MINISBLACK) << int(COMPRESSION_NONE)
                                 << QByteArray("ImageJ=1.53\nimages=900\nslices=900\n")
                                 << QStringLiteral("900 pictures but has one directory");
}

void ImageStackTest::picturesThatAreNotRead()
{
    QFETCH(int, photometric);
    QFETCH(int, compression);
    QFETCH(QByteArray, description);
    QFETCH(QString, says);
    const QString file = path(QStringLiteral("one.tif"));
    QVERIFY(writeTiff(file, {picture<std::uint8_t>(0, 32, 32)},
        {.compression = compression,
            .rowsPerStrip = 32,
            .photometric = photometric,
            .description = description}));
    const Result<LoadedVolume> loaded = core::loadVolume(file, spacing);
    QVERIFY(!loaded);
    const QString text = test::errorText(loaded.error());
    QVERIFY2(text.contains(file) && text.contains(says), qPrintable(text));
}

BURIN_TEST(ImageStackTest)

} // namespace imageStackTest

#include "ImageStackTest.moc"
