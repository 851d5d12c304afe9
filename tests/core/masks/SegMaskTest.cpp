// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ProbabilityMap.h"
#include "core/export/common/ExportMask.h"
#include "core/masks/MaskOnVolume.h"
#include "core/masks/ReadProbabilities.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SmallSeries.h"

#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpls/djencode.h>

#include <functional>
#include <random>
#include <set>

namespace segMaskTest {

namespace {

using core::MaskNote;
using Labels = std::vector<std::uint8_t>;

/// Slices without labels at both ends and in the middle.
/// @param oneIn so many voxels has a label
Labels gappedLabels(const glm::ivec3& size, unsigned seed, unsigned oneIn)
{
    std::mt19937 random(seed);
    const std::size_t slice = std::size_t(size.x) * std::size_t(size.y);
    Labels labels(slice * std::size_t(size.z), 0);
    for (int k = 1; k < size.z; k += 2) {
        for (std::size_t i = 0; i < slice; ++i)
            labels[std::size_t(k) * slice + i] =
                random() % oneIn == 0 ? std::uint8_t(random() % 3) : std::uint8_t(0);
    }
    return labels;
}

Labels numbersOf(const core::MaskOnVolume& mask, const core::Volume& volume)
{
    Labels numbers(volume.geometry.voxelCount(), 0);
    for (std::size_t i = 0; i < mask.segments.size(); ++i) {
        for (const core::VoxelRun& run : mask.segments[i].voxels.runs())
            std::fill_n(
                numbers.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(i + 1));
    }
    return numbers;
}

struct Exported {
    Exported(const test::SmallSeries& series, bool multiFrame = false, unsigned oneIn = 1)
        : volume(multiFrame ? series.writeMultiFrame(images) : series.write(images))
        , labels(gappedLabels(series.size, 11, oneIn))
    {
        std::vector<core::Segment> segments;
        for (int label = 1; label < 3; ++label) {
            core::Segment segment;
            segment.label = std::uint8_t(label);
            segment.name = QStringLiteral("Part %1").arg(label);
            segment.code = {
                QStringLiteral("SCT"), QStringLiteral("10200004"), QStringLiteral("Liver")};
            segments.push_back(segment);
        }
        const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
        const auto written =
            core::exportMask(volume, {.file = file, .segments = segments, .planes = planes}, {});
        if (!written)
            qFatal("%s", qPrintable(written.error().arguments.join(QStringLiteral(" | "))));
    }
    void change(const std::function<void(DcmDataset&)>& how,
        E_TransferSyntax syntax = EXS_LittleEndianExplicit) const
    {
        DcmFileFormat format;
        format.loadFile(qPrintable(file));
        format.loadAllDataIntoMemory();
        how(*format.getDataset());
        if (format.getDataset()->chooseRepresentation(syntax, nullptr).bad()
            || format.saveFile(qPrintable(file), syntax).bad())
            qFatal("cannot be saved");
    }
    [[nodiscard]] core::Result<core::MaskOnVolume> read() const
    {
        return core::readMask(file, volume, {});
    }

    QTemporaryDir folder;
    QString images = folder.filePath(QStringLiteral("images"));
    QString file = folder.filePath(QStringLiteral("seg.dcm"));
    core::Volume volume;
    Labels labels;
};

test::SmallSeries evenSeries(const glm::dvec3& step = {0, 0, 1.5})
{
    test::SmallSeries series;
    series.placeEvenly({-3, 4, 5}, step);
    return series;
}

int framesOf(DcmDataset& set)
{
    OFString text;
    set.findAndGetOFString(DCM_NumberOfFrames, text);
    return std::stoi(text);
}

/// The number of a frame's segment.
int segmentOf(DcmDataset& set, int frame)
{
    DcmItem* item = nullptr;
    set.findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, item, frame);
    DcmItem* identification = nullptr;
    item->findAndGetSequenceItem(DCM_SegmentIdentificationSequence, identification);
    Uint16 number = 0;
    identification->findAndGetUint16(DCM_ReferencedSegmentNumber, number);
    return number;
}

/// Pixels of a BINARY object, a byte each.
std::vector<Uint8> pixelsOf(DcmDataset& set, std::size_t count)
{
    const Uint8* bits = nullptr;
    set.findAndGetUint8Array(DCM_PixelData, bits);
    std::vector<Uint8> pixels(count);
    for (std::size_t i = 0; i < count; ++i)
        pixels[i] = (bits[i / 8] >> (i % 8)) & 1;
    return pixels;
}

/// @param pixels a byte each, stored in 8 or 16 bits
void setPixels(DcmDataset& set, const char* type, std::vector<Uint8> pixels, int bits = 8)
{
    set.putAndInsertString(DCM_SegmentationType, type);
    set.putAndInsertUint16(DCM_BitsAllocated, Uint16(bits));
    set.putAndInsertUint16(DCM_BitsStored, Uint16(bits));
    set.putAndInsertUint16(DCM_HighBit, Uint16(bits - 1));
    delete set.remove(DCM_PixelData);
    if (bits == 16) {
        const std::vector<Uint16> wide(pixels.begin(), pixels.end());
        set.putAndInsertUint16Array(DCM_PixelData, wide.data(), wide.size());
        return;
    }
    if (pixels.size() % 2 != 0)
        pixels.push_back(0);
    set.putAndInsertUint8Array(DCM_PixelData, pixels.data(), pixels.size());
}

/// Both segments' frames stay: pixels of either bear their own segment's number.
/// @param repeated the frames of a plane bear the numbers of both
void makeLabelMap(DcmDataset& set, int bits, bool repeated = false)
{
    const std::size_t frame = 12 * 9;
    const int frames = framesOf(set);
    std::vector<Uint8> pixels = pixelsOf(set, frame * std::size_t(frames));
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = Uint8(pixels[i] * segmentOf(set, int(i / frame)));
    // The first half are the frames of segment 1; the others lie where these do.
    const std::size_t half = pixels.size() / 2;
    for (std::size_t i = 0; repeated && i < half; ++i)
        pixels[i] = pixels[half + i] = std::max(pixels[i], pixels[half + i]);
    set.putAndInsertString(DCM_SOPClassUID, "1.2.840.10008.5.1.4.1.1.66.7");
    setPixels(set, "LABELMAP", pixels, bits);
}

} // namespace

class SegMaskTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyStackComesBack_data()
    {
        QTest::addColumn<int>("which");
        int which = 0;
        for (const char* name :
            {"axial", "oblique", "tilted", "uneven", "two slices", "multi-frame", "sparse"})
            QTest::newRow(name) << which++;
    }
    void everyStackComesBack()
    {
        QFETCH(int, which);
        test::SmallSeries series = evenSeries();
        if (which == 1) {
            series.rowDirection = glm::normalize(glm::dvec3(0.8, 0.5, 0.33));
            series.columnDirection = glm::normalize(
                glm::cross(glm::normalize(glm::dvec3(-0.2, -0.6, 0.9)), series.rowDirection));
            const glm::dvec3 normal = glm::cross(series.rowDirection, series.columnDirection);
            series.placeEvenly({10, -20, 30}, 1.25 * normal);
        } else if (which == 2) {
            series.placeEvenly({0, 0, 0}, {0, 0.5, 1.4});
        } else if (which == 3) {
            series.positions = {
                {0, 0, 0}, {0, 0, 1}, {0, 0, 2.5}, {0, 0, 3.5}, {0, 0, 7}, {0, 0, 8}};
        } else if (which == 4) {
            series.size.z = 2;
            series.positions = {{0, 0, 0}, {0, 0, 3}};
        }
        const Exported on(series, which == 5, which == 6 ? 30 : 1);
        const auto mask = on.read();
        QVERIFY2(mask, qPrintable(mask ? QString() : mask.error().arguments.join(u' ')));
        QVERIFY(mask->notes.empty());
        QCOMPARE(numbersOf(*mask, on.volume), on.labels);
        QCOMPARE(mask->segments.front().name, QStringLiteral("Part 1"));
        QCOMPARE(mask->segments.front().code.value, QStringLiteral("10200004"));
    }

    /// Frames say where they are; their order says nothing.
    void framesInAnyOrder()
    {
        const Exported on(evenSeries());
        on.change([](DcmDataset& set) {
            const int frames = framesOf(set);
            const std::size_t pixels = 12 * 9;
            const std::vector<Uint8> all = pixelsOf(set, pixels * std::size_t(frames));
            DcmSequenceOfItems* groups = nullptr;
            set.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, groups);
            std::vector<Uint8> turned;
            for (int frame = frames - 1; frame >= 0; --frame)
                turned.insert(turned.end(), all.begin() + std::ptrdiff_t(pixels) * frame,
                    all.begin() + std::ptrdiff_t(pixels) * (frame + 1));
            for (int frame = 0; frame < frames; ++frame)
                groups->insert(
                    groups->remove(frames - 1), static_cast<unsigned long>(frame), OFTrue);
            std::vector<Uint8> bits((turned.size() + 15) / 16 * 2, 0);
            for (std::size_t i = 0; i < turned.size(); ++i)
                bits[i / 8] = Uint8(bits[i / 8] | turned[i] << (i % 8));
            delete set.remove(DCM_PixelData);
            set.putAndInsertUint8Array(DCM_PixelData, bits.data(), bits.size());
        });
        const auto mask = on.read();
        QVERIFY(mask);
        QCOMPARE(numbersOf(*mask, on.volume), on.labels);
    }

    void fractionsFromOneHalf()
    {
        const Exported on(evenSeries());
        on.change([](DcmDataset& set) {
            std::vector<Uint8> pixels = pixelsOf(set, 12 * 9 * std::size_t(framesOf(set)));
            for (std::size_t i = 0; i < pixels.size(); ++i)
                pixels[i] = pixels[i] ? (i % 2 ? 50 : 99) : (i % 2 ? 49 : 0);
            set.putAndInsertUint16(DCM_MaximumFractionalValue, 100);
            set.putAndInsertString(DCM_SegmentationFractionalType, "OCCUPANCY");
            setPixels(set, "FRACTIONAL", pixels);
        });
        const auto mask = on.read();
        QVERIFY(mask);
        QCOMPARE(numbersOf(*mask, on.volume), on.labels);
        QCOMPARE(mask->notes, (std::vector<MaskNote>{{.code = MaskNote::Code::Fractional}}));
    }

    void aFractionalSegIsAProbabilityMap()
    {
        const Exported on(evenSeries());
        const auto why = [&](const QString& segment) {
            const auto read = core::readProbabilities(
                {.segment = 1, .probabilityFile = on.file}, segment, on.volume, {});
            return read ? QString() : read.error().arguments.value(1);
        };
        QVERIFY(why(QStringLiteral("Part 2")).contains(QLatin1String("not fractional")));
        on.change([](DcmDataset& set) {
            std::vector<Uint8> pixels = pixelsOf(set, 12 * 9 * std::size_t(framesOf(set)));
            for (std::size_t i = 0; i < pixels.size(); ++i)
                pixels[i] = pixels[i] ? 80 : 15;
            set.putAndInsertUint16(DCM_MaximumFractionalValue, 100);
            set.putAndInsertString(DCM_SegmentationFractionalType, "PROBABILITY");
            setPixels(set, "FRACTIONAL", pixels);
        });
        const QString other = why(QStringLiteral("Kidney"));
        QVERIFY2(other.contains(QLatin1String("Part 1, Part 2")), qPrintable(other));
        const auto read = core::readProbabilities(
            {.segment = 1, .probabilityFile = on.file}, QStringLiteral("Part 2"), on.volume, {});
        QVERIFY(read);
        QCOMPARE(read->notes, std::vector<MaskNote>{});
        const auto bytes = core::ProbabilityMap::unpacked(
            *read->edit.probabilities, on.volume.geometry.voxelCount());
        QVERIFY(bytes);
        // Slices without a frame of the segment are certainly without it.
        std::set<int> elsewhere;
        for (std::size_t voxel = 0; voxel < on.labels.size(); ++voxel) {
            if (on.labels[voxel] == 2)
                QCOMPARE(int((*bytes)[voxel]), 204);
            else
                elsewhere.insert((*bytes)[voxel]);
        }
        QCOMPARE(elsewhere, (std::set<int>{0, 38}));
    }

    void labelMaps_data()
    {
        QTest::addColumn<bool>("repeated");
        QTest::newRow("a number in one frame of a plane") << false;
        QTest::newRow("all numbers in each of them") << true;
    }
    /// Pixels are numbers of segments.
    void labelMaps()
    {
        QFETCH(bool, repeated);
        const Exported on(evenSeries());
        on.change([repeated](DcmDataset& set) { makeLabelMap(set, 8, repeated); });
        const auto mask = on.read();
        QVERIFY2(mask, qPrintable(mask ? QString() : mask.error().arguments.join(u' ')));
        // What is there twice is counted twice, as if half of it lay outside.
        QCOMPARE(mask->notes.empty(), !repeated);
        QCOMPARE(numbersOf(*mask, on.volume), on.labels);
    }

    void compressedFrames_data()
    {
        QTest::addColumn<int>("syntax");
        QTest::addColumn<int>("bits");
        QTest::newRow("RLE, 8 bits") << int(EXS_RLELossless) << 8;
        QTest::newRow("RLE, 16 bits") << int(EXS_RLELossless) << 16;
        QTest::newRow("JPEG lossless") << int(EXS_JPEGProcess14SV1) << 8;
        QTest::newRow("JPEG-LS, 8 bits") << int(EXS_JPEGLSLossless) << 8;
        QTest::newRow("JPEG-LS, 16 bits") << int(EXS_JPEGLSLossless) << 16;
    }
    /// As writers of label maps make them, which need not be opened elsewhere first.
    void compressedFrames()
    {
        QFETCH(int, syntax);
        QFETCH(int, bits);
        DcmRLEEncoderRegistration::registerCodecs();
        DJEncoderRegistration::registerCodecs();
        DJLSEncoderRegistration::registerCodecs();
        const Exported on(evenSeries());
        on.change([&](DcmDataset& set) { makeLabelMap(set, bits); }, E_TransferSyntax(syntax));
        const auto mask = on.read();
        QVERIFY2(mask, qPrintable(mask ? QString() : mask.error().arguments.join(u' ')));
        QVERIFY(mask->notes.empty());
        QCOMPARE(numbersOf(*mask, on.volume), on.labels);

        // Cut within the last frame, it is refused as a whole.
        QFile file(on.file);
        QVERIFY(file.resize(file.size() - 40));
        const auto cut = on.read();
        QVERIFY(!cut);
        QCOMPARE(cut.error().arguments.value(0), on.file);
    }

    void compressedProbabilities()
    {
        DJLSEncoderRegistration::registerCodecs();
        const Exported on(evenSeries());
        const auto fractional = [](DcmDataset& set) {
            std::vector<Uint8> pixels = pixelsOf(set, 12 * 9 * std::size_t(framesOf(set)));
            // Values side by side: DCMTK 3.6.7 writes past the end of its memory where a frame that
            // it encodes as JPEG-LS gets larger than it was, as noise does.
            for (Uint8& pixel : pixels)
                pixel = pixel ? 50 : 49;
            set.putAndInsertUint16(DCM_MaximumFractionalValue, 100);
            set.putAndInsertString(DCM_SegmentationFractionalType, "OCCUPANCY");
            setPixels(set, "FRACTIONAL", pixels);
        };
        on.change(fractional, EXS_JPEGLSLossless);
        const auto mask = on.read();
        QVERIFY2(mask, qPrintable(mask ? QString() : mask.error().arguments.join(u' ')));
        QCOMPARE(numbersOf(*mask, on.volume), on.labels);
    }

    void whatCompressionChangedIsRefused()
    {
        DJEncoderRegistration::registerCodecs();
        const Exported on(evenSeries());
        on.change([](DcmDataset& set) { makeLabelMap(set, 8); }, EXS_JPEGProcess1);
        const auto mask = on.read();
        QVERIFY(!mask);
        QCOMPARE(mask.error().code, core::ErrorCode::UnsupportedFormat);
        QVERIFY2(mask.error().arguments.value(1).contains(QLatin1String("may change them")),
            qPrintable(mask.error().arguments.value(1)));
    }

    void namesInOtherCharacterSets()
    {
        const Exported on(evenSeries());
        on.change([](DcmDataset& set) {
            set.putAndInsertString(DCM_SpecificCharacterSet, "\\ISO 2022 IR 87");
            DcmItem* segment = nullptr;
            set.findAndGetSequenceItem(DCM_SegmentSequence, segment, 1);
            segment->putAndInsertString(DCM_SegmentLabel, "\033$BF,It\033(B");
        });
        const auto mask = on.read();
        QVERIFY(mask);
        QCOMPARE(mask->segments[0].name, QStringLiteral("Part 1"));
        QCOMPARE(mask->segments[1].name, QStringLiteral("頭部"));
    }

    /// Onto slices twice as far apart and shifted: those in between are left out, with a word.
    void anotherGrid()
    {
        const Exported on(evenSeries());
        core::Volume coarse = on.volume;
        coarse.geometry.size.z = 3;
        coarse.geometry.indexToWorld[2] *= 2.0;
        coarse.geometry.indexToWorld[3] += glm::dvec4(0, 0, 0.4, 0);
        const auto mask = core::readMask(on.file, coarse, {});
        QVERIFY(!mask); // slices 0, 2 and 4 have nothing
        coarse.geometry.indexToWorld[3] += glm::dvec4(0, 0, 1.5, 0);
        const auto odd = core::readMask(on.file, coarse, {});
        QVERIFY(odd);
        QVERIFY(odd->notes.front().code == MaskNote::Code::AnotherGrid);
        QVERIFY(odd->notes.front().fileMl > 0.0 && odd->notes.front().hereMl > 0.0);
        const std::size_t slice = 12 * 9;
        const Labels numbers = numbersOf(*odd, coarse);
        for (std::size_t k = 0; k < 3; ++k) {
            QVERIFY(std::equal(numbers.begin() + std::ptrdiff_t(k * slice),
                numbers.begin() + std::ptrdiff_t((k + 1) * slice),
                on.labels.begin() + std::ptrdiff_t((2 * k + 1) * slice)));
        }
    }

    /// Drawn on slices 5 mm apart, of which each is also a slice of a series with 1 mm.
    void thickSlicesOnThinOnes()
    {
        const Exported on(evenSeries({0, 0, 5}));
        core::Volume thin = on.volume;
        thin.sources.clear();
        thin.geometry.size.z = 28;
        thin.geometry.indexToWorld[2].z = 1.0;
        const auto mask = core::readMask(on.file, thin, {});
        QVERIFY2(mask, qPrintable(mask ? QString() : mask.error().arguments.join(u' ')));
        const std::size_t slice = 12 * 9;
        const Labels numbers = numbersOf(*mask, thin);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const std::size_t k = (i / slice + 2) / 5; // the nearest thick slice
            QCOMPARE(int(numbers[i]), k < 6 ? int(on.labels[k * slice + i % slice]) : 0);
        }
        QCOMPARE(mask->notes.size(), std::size_t(1));
        QVERIFY(mask->notes.front().code == MaskNote::Code::AnotherGrid);
        const auto drawn =
            on.labels.size() - std::size_t(std::count(on.labels.begin(), on.labels.end(), 0));
        const double voxelMl = thin.geometry.voxelVolumeMm3() / 1000.0;
        QVERIFY(std::abs(mask->notes.front().fileMl - 5.0 * double(drawn) * voxelMl) < 1e-6);
        QVERIFY(std::abs(mask->notes.front().hereMl - 5.0 * double(drawn) * voxelMl) < 1e-6);
    }

    void distancesThatMayBeWrong_data()
    {
        QTest::addColumn<double>("statedMm");
        QTest::addColumn<bool>("onThese"); // the file names the study's images
        QTest::addColumn<bool>("thick");
        QTest::newRow("that of the slices, others are empty") << 1.5 << false << false;
        QTest::newRow("that of the frames") << 3.0 << false << true;
        QTest::newRow("that of the frames, drawn on these slices") << 3.0 << true << false;
        QTest::newRow("one on which the frames do not lie") << 4.0 << false << false;
        QTest::newRow("a little more than the slices'") << 2.0 << false << false;
        QTest::newRow("not stated") << 0.0 << false << false;
    }
    /// Frames on every other slice of 1.5 mm, since those between are empty, or thicker.
    void distancesThatMayBeWrong()
    {
        QFETCH(double, statedMm);
        QFETCH(bool, onThese);
        QFETCH(bool, thick);
        const Exported on(evenSeries());
        on.change([statedMm](DcmDataset& set) {
            DcmItem* shared = nullptr;
            DcmItem* measures = nullptr;
            set.findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, shared);
            shared->findAndGetSequenceItem(DCM_PixelMeasuresSequence, measures);
            if (statedMm > 0.0)
                measures->putAndInsertString(
                    DCM_SpacingBetweenSlices, std::to_string(statedMm).c_str());
            else
                measures->findAndDeleteElement(DCM_SpacingBetweenSlices);
            // Slices may be thicker than they are apart.
            measures->putAndInsertString(DCM_SliceThickness, "3");
        });
        core::Volume study = on.volume;
        if (!onThese)
            study.sources.clear();
        const auto mask = core::readMask(on.file, study, {});
        QVERIFY2(mask, qPrintable(mask ? QString() : mask.error().arguments.join(u' ')));
        QCOMPARE(mask->notes.empty(), !thick);
        QCOMPARE(numbersOf(*mask, study) == on.labels, !thick);
    }

    void whatAReaderMustKnow()
    {
        const Exported on(evenSeries());
        core::Volume other = on.volume;
        other.identity.patientId = QStringLiteral("somebody else");
        other.identity.frameOfReferenceUid = QStringLiteral("1.2.3");
        const auto mask = core::readMask(on.file, other, {});
        QVERIFY(mask);
        QCOMPARE(mask->notes, // nobody's name
            (std::vector<MaskNote>{{.code = MaskNote::Code::AnotherPatient},
                {.code = MaskNote::Code::AnotherFrameOfReference}}));
        other.geometry.indexToWorld[3] += glm::dvec4(0, 0, 300, 0);
        QCOMPARE(core::readMask(on.file, other, {}).error().arguments.value(1),
            QStringLiteral("it lies wholly outside the study"));
        on.change([](DcmDataset& set) { set.putAndInsertString(DCM_SegmentationType, "GUESSED"); });
        QCOMPARE(on.read().error().arguments.value(1), QStringLiteral("of type 'GUESSED'"));
    }
};

BURIN_TEST(SegMaskTest)

} // namespace segMaskTest

#include "SegMaskTest.moc"
