// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ProbabilityMap.h"
#include "core/export/common/ExportMask.h"
#include "core/masks/MaskOnVolume.h"
#include "core/masks/ReadProbabilities.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/NrrdFiles.h"
#include "tests/support/series/SmallSeries.h"
#include "tests/support/series/VolumeFiles.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

namespace labelMaskTest {

namespace {

using core::MaskNote;
using Labels = std::vector<std::uint8_t>;
using Notes = std::vector<MaskNote>;
using Random = std::mt19937;

core::Volume volumeOf(const glm::ivec3& size, const glm::dmat4& affine)
{
    core::Volume volume;
    volume.geometry.size = size;
    volume.geometry.indexToWorld = affine;
    return volume;
}

/// Oblique, with steps of 0.75, 1.25 and 2 mm.
glm::dmat4 obliqueAffine()
{
    const glm::dvec3 row = glm::normalize(glm::dvec3(0.9, 0.3, -0.2));
    const glm::dvec3 normal = glm::normalize(glm::cross(row, glm::dvec3(0.1, 1.0, 0.4)));
    const glm::dvec3 column = glm::cross(normal, row);
    return {glm::dvec4(0.75 * row, 0), glm::dvec4(1.25 * column, 0), glm::dvec4(2.0 * normal, 0),
        glm::dvec4(-11, 23, 47, 1)};
}

Labels randomLabels(const glm::ivec3& size, Random& random)
{
    Labels labels(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (std::uint8_t& label : labels)
        label = std::uint8_t(random() % 4);
    return labels;
}

std::size_t placeOf(const glm::ivec3& size, const glm::ivec3& voxel)
{
    return (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y)) * std::size_t(size.x)
        + std::size_t(voxel.x);
}

QByteArray vectorText(const glm::dvec4& vector)
{
    QByteArray text;
    for (int part = 0; part < 3; ++part)
        text += (part ? "," : "(") + QByteArray::number(vector[part], 'g', 17);
    return text + ')';
}

QByteArray nrrd(const glm::ivec3& size, const glm::dmat4& affine, const Labels& labels,
    const QByteArray& more = {}, int layers = 1)
{
    const bool several = layers > 1;
    QByteArray text = "NRRD0004\ntype: uchar\nencoding: raw\nspace: left-posterior-superior\n";
    text += several ? "dimension: 4\nkinds: list domain domain domain\n" : "dimension: 3\n";
    text += "sizes: " + (several ? QByteArray::number(layers) + ' ' : QByteArray());
    for (int axis = 0; axis < 3; ++axis)
        text += QByteArray::number(size[axis]) + ' ';
    text += QByteArray("\nspace directions: ") + (several ? "none " : "");
    for (int axis = 0; axis < 3; ++axis)
        text += vectorText(affine[axis]) + ' ';
    text += "\nspace origin: " + vectorText(affine[3]) + '\n' + more + '\n';
    return text
        + QByteArray(reinterpret_cast<const char*>(labels.data()), qsizetype(labels.size()));
}

/// Numbers of segments by voxel, from 1; 0: none. Of segments that overlap, the first one's.
Labels numbersOf(const core::MaskOnVolume& mask, const core::Volume& volume)
{
    Labels numbers(volume.geometry.voxelCount(), 0);
    for (std::size_t i = 0; i < mask.segments.size(); ++i) {
        for (const core::VoxelRun& run : mask.segments[i].voxels.runs()) {
            for (std::uint64_t at = 0; at < run.count; ++at) {
                std::uint8_t& number = numbers[run.first + at];
                number = number == 0 ? std::uint8_t(i + 1) : number;
            }
        }
    }
    return numbers;
}

} // namespace

/// Label maps as segments on a study's grid.
class LabelMaskTest : public QObject, protected test::VolumeFiles {
    Q_OBJECT

private Q_SLOTS:
    void init() { makeFolder(); }

    void everyOrderOfTheAxes()
    {
        Random random(3);
        const glm::ivec3 size(7, 5, 4);
        const core::Volume volume = volumeOf(size, obliqueAffine());
        const Labels labels = randomLabels(size, random);
        std::array<int, 3> order{0, 1, 2};
        do {
            for (int flips = 0; flips < 8; ++flips) {
                // Axis a of the file runs along axis order[a] of the volume, or against it.
                glm::dmat4 affine = volume.geometry.indexToWorld;
                glm::ivec3 fileSize(0);
                for (int axis = 0; axis < 3; ++axis) {
                    const int along = order[std::size_t(axis)];
                    const bool against = ((flips >> axis) & 1) != 0;
                    fileSize[axis] = size[along];
                    affine[axis] = volume.geometry.indexToWorld[along] * (against ? -1.0 : 1.0);
                    if (against)
                        affine[3] += volume.geometry.indexToWorld[along] * double(size[along] - 1);
                }
                Labels file(labels.size());
                for (int z = 0; z < fileSize.z; ++z)
                    for (int y = 0; y < fileSize.y; ++y)
                        for (int x = 0; x < fileSize.x; ++x) {
                            const glm::ivec3 at(x, y, z);
                            glm::ivec3 voxel(0);
                            for (int axis = 0; axis < 3; ++axis) {
                                const int along = order[std::size_t(axis)];
                                voxel[along] = ((flips >> axis) & 1) != 0
                                    ? size[along] - 1 - at[axis]
                                    : at[axis];
                            }
                            file[placeOf(fileSize, at)] = labels[placeOf(size, voxel)];
                        }
                const auto mask = read(nrrd(fileSize, affine, file), volume);
                QVERIFY(mask);
                QVERIFY(mask->notes.empty());
                QCOMPARE(numbersOf(*mask, volume), labels);
            }
        } while (std::next_permutation(order.begin(), order.end()));
    }

    void aPartOfTheGridAndMore()
    {
        Random random(4);
        const core::Volume volume = volumeOf({7, 5, 4}, obliqueAffine());
        const glm::ivec3 from(3, -2, 1); // of the file's first voxel
        const glm::ivec3 size(6, 5, 2);
        glm::dmat4 affine = obliqueAffine();
        affine[3] = affine * glm::dvec4(glm::dvec3(from), 1.0);
        const Labels labels = randomLabels(size, random);
        const auto mask = read(nrrd(size, affine, labels), volume);
        QVERIFY(mask);
        Labels expected(volume.geometry.voxelCount(), 0);
        std::size_t outside = 0;
        std::size_t labelled = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const std::uint8_t label = labels[placeOf(size, {x, y, z})];
                    const glm::ivec3 voxel = from + glm::ivec3(x, y, z);
                    labelled += label != 0 ? 1 : 0;
                    if (volume.geometry.contains(voxel))
                        expected[placeOf(volume.geometry.size, voxel)] = label;
                    else
                        outside += label != 0 ? 1 : 0;
                }
        QCOMPARE(numbersOf(*mask, volume), expected);
        QCOMPARE(mask->notes,
            (Notes{{.code = MaskNote::Code::OutsideStudy,
                .some = std::uint64_t(outside),
                .all = std::uint64_t(labelled)}}));
    }

    /// Against the plain rule, in doubles, wherever rounding cannot matter.
    void nearestVoxels()
    {
        Random random(5);
        int compared = 0;
        for (int round = 0; round < 20; ++round) {
            const auto unit = [&random] { return double(random()) / 4294967296.0; };
            core::Volume volume = volumeOf({9, 11, 6}, obliqueAffine());
            if (round % 3 == 0) {
                for (int k = 0; k < 6; ++k)
                    volume.geometry.slicePositions.emplace_back(
                        volume.geometry.toWorld({0.3 * unit(), 0.2 * unit(), k + 0.4 * unit()}));
            }
            const glm::ivec3 size(8, 7, 9);
            glm::dmat4 affine(1.0);
            for (int axis = 0; axis < 3; ++axis) {
                for (int part = 0; part < 3; ++part)
                    affine[axis][part] = (axis == part ? 1.3 : 0.0) + 0.3 * (unit() - 0.5);
            }
            affine[3] = glm::dvec4(
                volume.geometry.toWorld({-1.0, 1.0, 0.5}) + glm::dvec3(unit(), unit(), unit()), 1);
            const Labels labels = randomLabels(size, random);
            const auto mask = read(nrrd(size, affine, labels), volume);
            QVERIFY(mask);
            const auto isOnGrid = [](const MaskNote& note) {
                return note.code == MaskNote::Code::AnotherGrid;
            };
            QCOMPARE(std::count_if(mask->notes.begin(), mask->notes.end(), isOnGrid), 1);
            // Segments stand in the order of their labels, and those without a voxel are left out.
            std::array<std::uint8_t, 4> labelOf{};
            for (std::size_t i = 0; i < mask->segments.size(); ++i)
                labelOf[i + 1] = std::uint8_t(mask->segments[i].name.last(1).toInt());
            const Labels numbers = numbersOf(*mask, volume);
            const glm::dmat4 toFile = glm::inverse(affine);
            for (int k = 0; k < 6; ++k)
                for (int j = 0; j < 11; ++j)
                    for (int i = 0; i < 9; ++i) {
                        glm::dvec3 world = volume.geometry.toWorld({i, j, k});
                        if (!volume.geometry.slicePositions.empty())
                            world = volume.geometry.slicePositions[std::size_t(k)]
                                + double(i) * glm::dvec3(volume.geometry.indexToWorld[0])
                                + double(j) * glm::dvec3(volume.geometry.indexToWorld[1]);
                        const glm::dvec3 at(toFile * glm::dvec4(world, 1.0));
                        const glm::dvec3 nearest = glm::floor(at + 0.5);
                        const glm::dvec3 off = glm::abs(at - nearest);
                        if (std::max({off.x, off.y, off.z}) > 0.499)
                            continue;
                        const bool inside = glm::all(glm::greaterThanEqual(nearest, glm::dvec3(0)))
                            && glm::all(glm::lessThan(nearest, glm::dvec3(size)));
                        const int wanted = inside ? labels[placeOf(size, glm::ivec3(nearest))] : 0;
                        const int found =
                            labelOf[numbers[placeOf(volume.geometry.size, {i, j, k})]];
                        QCOMPARE(found, wanted);
                        ++compared;
                    }
        }
        QVERIFY(compared > 10000);
    }

    /// Half a step off, every voxel lies midway: the greater index has it.
    void midwayIsTheGreaterOnes()
    {
        const glm::ivec3 size(6, 1, 1);
        const core::Volume volume = volumeOf(size, glm::dmat4(1.0));
        const Labels labels{1, 2, 3, 1, 2, 3};
        for (const double noise : {0.0, 1e-6, -1e-6, -1e-5}) {
            glm::dmat4 affine(1.0);
            affine[3][0] = 0.5 + noise; // volume voxel i lies at i − 0.5
            const auto mask = read(nrrd(size, affine, labels), volume);
            QVERIFY(mask);
            QCOMPARE(numbersOf(*mask, volume), labels);
            QCOMPARE(mask->notes.size(), std::size_t(1)); // the last voxel reaches into the study
        }
        glm::dmat4 hardly(1.0);
        hardly[3][0] = 0.004; // what rounded headers are off by
        const auto mask = read(nrrd(size, hardly, labels), volume);
        QVERIFY(mask);
        QVERIFY(mask->notes.empty());
    }

    void layersNamesAndColours()
    {
        const glm::ivec3 size(4, 3, 2);
        const core::Volume volume = volumeOf(size, obliqueAffine());
        Labels labels(48, 0); // two layers a voxel
        for (std::size_t voxel = 0; voxel < 10; ++voxel)
            labels[2 * voxel] = 1;
        for (std::size_t voxel = 5; voxel < 20; ++voxel)
            labels[2 * voxel + 1] = voxel < 12 ? 1 : 7;
        const QByteArray keys =
            "Segment0_ID:=a\nSegment0_Name:=Leber\xc3\xa4\nSegment0_Color:=1 0.5 0\n"
            "Segment0_LabelValue:=1\nSegment0_Layer:=0\n"
            "Segment0_Tags:=Foo:1|TerminologyEntry:x~SCT^123037004^Anatomical Structure~"
            "SCT^10200004^Liver~^^~y~^^~^^|\n"
            "Segment1_ID:=b\nSegment1_Name:=Gone\nSegment1_LabelValue:=4\nSegment1_Layer:=0\n"
            "Segment2_ID:=c\nSegment2_Name:=Vein\nSegment2_LabelValue:=7\nSegment2_Layer:=1\n";
        const auto mask = read(nrrd(size, obliqueAffine(), labels, keys, 2), volume);
        QVERIFY(mask);
        QCOMPARE(mask->segments.size(), std::size_t(3));
        QCOMPARE(mask->segments[0].name, QString::fromUtf8("Leber\xc3\xa4"));
        QCOMPARE(*mask->segments[0].rgb, 0xff8000U);
        QCOMPARE(mask->segments[0].code.value, QStringLiteral("10200004"));
        QCOMPARE(mask->segments[0].voxels.runs(), (std::vector<core::VoxelRun>{{0, 10}}));
        QCOMPARE(mask->segments[1].name, QStringLiteral("Vein"));
        QVERIFY(!mask->segments[1].rgb);
        QCOMPARE(mask->segments[1].voxels.runs(), (std::vector<core::VoxelRun>{{12, 8}}));
        QCOMPARE(mask->segments[2].name, QStringLiteral("Label 1, layer 2"));
        QCOMPARE(mask->segments[2].voxels.runs(), (std::vector<core::VoxelRun>{{5, 7}}));
        QCOMPARE(mask->notes, (Notes{{.code = MaskNote::Code::SegmentsOverlap, .some = 5}}));
    }

    void whatBurinWroteComesBack()
    {
        test::SmallSeries series;
        series.placeEvenly({-20, 10, 5}, {0, 0.4, 1.5});
        const core::Volume volume = series.write(m_folder->filePath(QStringLiteral("images")));
        Random random(6);
        const Labels labels = randomLabels(volume.geometry.size, random);
        std::vector<core::Segment> segments;
        for (int label = 1; label < 4; ++label) {
            core::Segment segment;
            segment.label = std::uint8_t(label);
            segment.name = QStringLiteral("Teil %1").arg(label);
            segment.rgb = 0x102030U * unsigned(label);
            segment.code = {QStringLiteral("SCT"), QStringLiteral("1020%1").arg(label),
                QStringLiteral("Liver")};
            segments.push_back(segment);
        }
        const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
        for (const auto& [format, name] :
            {std::pair(core::ExportFormat::SegNrrd, QStringLiteral("a.seg.nrrd")),
                std::pair(core::ExportFormat::Nifti, QStringLiteral("a.nii.gz")),
                std::pair(core::ExportFormat::DicomSeg, QStringLiteral("a.dcm"))}) {
            const QString file = m_folder->filePath(name);
            const auto written = core::exportMask(volume,
                {.format = format, .file = file, .segments = segments, .planes = planes}, {});
            QVERIFY(written);
            const auto mask = core::readMask(file, volume, {});
            QVERIFY(mask);
            QVERIFY(mask->notes.empty());
            QCOMPARE(numbersOf(*mask, volume), labels);
            for (std::size_t i = 0; format != core::ExportFormat::Nifti && i < 3; ++i) {
                QCOMPARE(mask->segments[i].name, segments[i].name);
                QCOMPARE(mask->segments[i].code, segments[i].code);
                QCOMPARE(*mask->segments[i].rgb, segments[i].rgb);
            }
        }
    }

    void refusals()
    {
        const glm::ivec3 size(4, 3, 2);
        const core::Volume volume = volumeOf(size, obliqueAffine());
        const auto why = [&](const QByteArray& bytes) {
            const auto mask = read(bytes, volume);
            return mask ? QString() : mask.error().arguments.value(1);
        };
        const Labels ones(24, 1);
        glm::dmat4 far = obliqueAffine();
        far[3] += glm::dvec4(500, 0, 0, 0);
        QCOMPARE(why(nrrd(size, far, ones)), QStringLiteral("it lies wholly outside the study"));
        QCOMPARE(
            why(nrrd(size, obliqueAffine(), Labels(24, 0))), QStringLiteral("it has no label"));
        QByteArray negative = nrrd(size, obliqueAffine(), ones);
        negative.replace("type: uchar", "type: signed char");
        negative[negative.size() - 1] = char(-3);
        QCOMPARE(why(negative), QStringLiteral("its values are not labels: -3 is among them"));
        QVERIFY(!why(nrrd(size, obliqueAffine(), Labels(20, 1))).isEmpty()); // cut
        glm::dmat4 tiny = obliqueAffine();
        for (int axis = 0; axis < 3; ++axis)
            tiny[axis] *= 1e-6;
        QCOMPARE(why(nrrd(size, tiny, ones)),
            QStringLiteral("its voxels are out of all proportion to the study's"));
        for (const QString& path : {m_folder->path(), m_folder->filePath(QStringLiteral("no.nrrd")),
                 put(QStringLiteral("text.dcm"), "no mask at all")})
            QVERIFY(!core::readMask(path, volume, {}));
    }

    /// What a network says of a structure: floats from 0 to 1.
    void sharesAreTakenFromOneHalf()
    {
        const glm::ivec3 size(5, 4, 3);
        const core::Volume volume = volumeOf(size, obliqueAffine());
        Random random(9);
        std::vector<float> shares(60);
        Labels expected;
        for (float& share : shares) {
            share = float(random() % 1001) / 1000.0f;
            expected.push_back(share >= 0.5f ? 1 : 0);
        }
        const auto mask = read(floats(size, obliqueAffine(), shares), volume);
        QVERIFY(mask);
        QCOMPARE(numbersOf(*mask, volume), expected);
        QCOMPARE(mask->notes, (Notes{{.code = MaskNote::Code::Fractional}}));
        shares[7] = 1.5f; // neither a share nor a label
        QVERIFY(!read(floats(size, obliqueAffine(), shares), volume));
    }

    void probabilityMapsAreReadByTheVoxel()
    {
        const glm::ivec3 size(5, 4, 3);
        const core::Volume volume = volumeOf(size, obliqueAffine());
        Random random(10);
        std::vector<float> shares(60);
        for (float& share : shares)
            share = float(random() % 256) / 255.0f;
        const auto bytesOf = [&](const core::Volume& study) {
            const core::DivideSegment asked{.segment = 1,
                .probabilityFile =
                    put(QStringLiteral("map.nrrd"), floats(size, obliqueAffine(), shares))};
            const auto read = core::readProbabilities(asked, {}, study, {});
            if (!read)
                qFatal("%s", qPrintable(read.error().arguments.join(QStringLiteral(" | "))));
            if (read->edit.probabilityFile || !read->edit.probabilities)
                qFatal("the edit is not complete");
            return std::pair(*core::ProbabilityMap::unpacked(
                                 *read->edit.probabilities, study.geometry.voxelCount()),
                read->notes);
        };
        const auto [same, without] = bytesOf(volume);
        for (std::size_t voxel = 0; voxel < shares.size(); ++voxel)
            QCOMPARE(int(same[voxel]), int(std::lround(shares[voxel] * 255.0f)));
        QCOMPARE(without, Notes{});

        // Another grid: two columns further, and one beyond the map's end.
        glm::dmat4 shifted = obliqueAffine();
        shifted[3] += 2.25 * shifted[0];
        const auto [moved, notes] = bytesOf(volumeOf({4, 4, 3}, shifted));
        for (int x = 0; x < 4; ++x) {
            const int expected = x + 2 < 5 ? int(same[placeOf(size, {x + 2, 1, 1})]) : 0;
            QCOMPARE(int(moved[placeOf({4, 4, 3}, {x, 1, 1})]), expected);
        }
        QCOMPARE(notes, (Notes{{.code = MaskNote::Code::MapOnAnotherGrid}}));

        const auto why = [&](const QByteArray& file) {
            const core::DivideSegment asked{
                .segment = 1, .probabilityFile = put(QStringLiteral("map.nrrd"), file)};
            const auto read = core::readProbabilities(asked, {}, volume, {});
            return read ? QString() : read.error().arguments.value(1);
        };
        std::vector<float> wild = shares;
        wild[3] = 37.0f;
        QVERIFY(why(floats(size, obliqueAffine(), wild)).contains(QLatin1String("37")));
        QVERIFY(!why(floats(size, obliqueAffine(), std::vector<float>(60, 0.0f))).isEmpty());
        Labels bytes(60, 0);
        bytes[5] = 200;
        QCOMPARE(why(nrrd(size, obliqueAffine(), bytes)), QString());
        QVERIFY(!why(nrrd(size, obliqueAffine(), Labels(120, 1), {}, 2)).isEmpty());
    }

private:
    static QByteArray floats(
        const glm::ivec3& size, const glm::dmat4& affine, const std::vector<float>& values)
    {
        Labels bytes(values.size() * sizeof(float));
        std::memcpy(bytes.data(), values.data(), bytes.size());
        QByteArray file = nrrd(size, affine, bytes, "endian: little\n");
        return file.replace("type: uchar", "type: float");
    }
    core::Result<core::MaskOnVolume> read(const QByteArray& bytes, const core::Volume& volume)
    {
        return core::readMask(put(QStringLiteral("mask.nrrd"), bytes), volume, {});
    }
};

BURIN_TEST(LabelMaskTest)

} // namespace labelMaskTest

#include "LabelMaskTest.moc"
