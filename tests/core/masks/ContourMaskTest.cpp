// SPDX-License-Identifier: Apache-2.0
#include "core/masks/MaskOnVolume.h"
#include "core/masks/PolygonFill.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cmath>
#include <random>
#include <set>

namespace contourMaskTest {

namespace {

using core::MaskNote;
using core::SlicePolygon;
using Voxel = std::pair<int, int>; ///< row, column

std::set<Voxel> filled(const std::vector<SlicePolygon>& polygons, const glm::ivec2& size)
{
    std::set<Voxel> voxels;
    core::fillPolygons(polygons, size, [&](int row, int from, int to) {
        for (int column = from; column < to; ++column)
            voxels.insert({row, column});
    });
    return voxels;
}

SlicePolygon polygonOf(const std::vector<glm::dvec2>& points)
{
    SlicePolygon polygon;
    for (const glm::dvec2& point : points)
        polygon.points.push_back(core::slicePoint(point));
    return polygon;
}

/// How often the curves go around a place, by angles.
int windings(const std::vector<glm::dvec2>& points, const glm::dvec2& place)
{
    double angle = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec2 a = points[i] - place;
        const glm::dvec2 b = points[(i + 1) % points.size()] - place;
        angle += std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
    }
    return int(std::lround(angle / (2.0 * std::acos(-1.0))));
}

core::Volume boxVolume()
{
    core::Volume volume;
    volume.geometry.size = {20, 16, 5};
    volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(2, 0, 0, 0), glm::dvec4(0, 1.5, 0, 0),
        glm::dvec4(0, 0, 3, 0), glm::dvec4(-10, 5, 100, 1));
    return volume;
}

/// A contour by columns and rows of boxVolume(), at a height.
std::string contourData(const std::vector<glm::dvec2>& points, double zMm)
{
    std::string text;
    for (const glm::dvec2& point : points) {
        for (const double part : {-10.0 + 2.0 * point.x, 5.0 + 1.5 * point.y, zMm})
            text += (text.empty() ? "" : "\\") + std::to_string(part);
    }
    return text;
}

/// Five slices that lie along no axis, 3 mm apart.
core::Volume obliqueVolume()
{
    core::Volume volume;
    volume.geometry.size = {20, 16, 5};
    const glm::dvec3 row = glm::normalize(glm::dvec3(0.8, 0.5, 0.33));
    const glm::dvec3 column =
        glm::normalize(glm::cross(glm::normalize(glm::dvec3(-0.2, -0.6, 0.9)), row));
    volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(2.0 * row, 0), glm::dvec4(1.5 * column, 0),
        glm::dvec4(3.0 * glm::cross(row, column), 0), glm::dvec4(-31.37, 17.13, 101.77, 1));
    return volume;
}

/// A contour by columns and rows of a volume, at a place between its slices, in coordinates with so
/// many decimals.
std::string roundedData(
    const core::Volume& volume, const std::vector<glm::dvec2>& points, double k, int decimals)
{
    QByteArray text;
    for (const glm::dvec2& point : points) {
        const glm::dvec3 lps = volume.geometry.toWorld({point.x, point.y, k});
        for (int axis = 0; axis < 3; ++axis)
            text += (text.isEmpty() ? "" : "\\") + QByteArray::number(lps[axis], 'f', decimals);
    }
    return text.toStdString();
}

std::vector<glm::dvec2> boxOf(double left, double top, double right, double bottom)
{
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

struct Drawn {
    std::string name;
    std::vector<std::string> contours;
    std::string type = "CLOSED_PLANAR";
};

void write(const QString& path, const std::vector<Drawn>& rois)
{
    DcmFileFormat file;
    DcmDataset& set = *file.getDataset();
    set.putAndInsertString(DCM_SOPClassUID, UID_RTStructureSetStorage);
    set.putAndInsertString(DCM_SOPInstanceUID, "2.25.99");
    set.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 192");
    int number = 3;
    for (const Drawn& roi : rois) {
        DcmItem* item = nullptr;
        set.findOrCreateSequenceItem(DCM_StructureSetROISequence, item, -2);
        item->putAndInsertString(DCM_ROINumber, std::to_string(number).c_str());
        item->putAndInsertString(DCM_ROIName, roi.name.c_str());
        set.findOrCreateSequenceItem(DCM_ROIContourSequence, item, -2);
        item->putAndInsertString(DCM_ROIDisplayColor, "255\\128\\0");
        item->putAndInsertString(DCM_ReferencedROINumber, std::to_string(number).c_str());
        for (const std::string& data : roi.contours) {
            DcmItem* contour = nullptr;
            item->findOrCreateSequenceItem(DCM_ContourSequence, contour, -2);
            contour->putAndInsertString(DCM_ContourGeometricType, roi.type.c_str());
            contour->putAndInsertString(DCM_ContourData, data.c_str());
        }
        number += 2;
    }
    QVERIFY(file.saveFile(qPrintable(path), EXS_LittleEndianImplicit).good());
}

std::set<std::uint64_t> placesOf(const core::VoxelRuns& runs)
{
    std::set<std::uint64_t> places;
    for (const core::VoxelRun& run : runs.runs()) {
        for (std::uint64_t at = 0; at < run.count; ++at)
            places.insert(run.first + at);
    }
    return places;
}

std::uint64_t placeAt(int column, int row, int k)
{
    return (std::uint64_t(k) * 16 + std::uint64_t(row)) * 20 + std::uint64_t(column);
}

} // namespace

class ContourMaskTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void insideIsAnOddNumberOfWindings()
    {
        std::mt19937 random(7);
        const glm::ivec2 size(24, 19);
        int compared = 0;
        for (int round = 0; round < 200; ++round) {
            std::vector<std::vector<glm::dvec2>> curves(1 + random() % 3);
            std::vector<SlicePolygon> polygons;
            for (std::vector<glm::dvec2>& curve : curves) {
                for (unsigned point = 3 + random() % 12; point > 0; --point)
                    curve.emplace_back(double(random() % 30000) / 1000.0 - 3.0,
                        double(random() % 25000) / 1000.0 - 3.0);
                polygons.push_back(polygonOf(curve));
            }
            const std::set<Voxel> voxels = filled(polygons, size);
            for (int row = 0; row < size.y; ++row) {
                for (int column = 0; column < size.x; ++column) {
                    int around = 0;
                    double nearest = 1.0;
                    for (const std::vector<glm::dvec2>& curve : curves) {
                        around += windings(curve, glm::dvec2(column, row));
                        for (std::size_t i = 0; i < curve.size(); ++i) {
                            const glm::dvec2 a = curve[i];
                            const glm::dvec2 along = curve[(i + 1) % curve.size()] - a;
                            const double t = std::clamp(glm::dot(glm::dvec2(column, row) - a, along)
                                    / glm::dot(along, along),
                                0.0, 1.0);
                            nearest = std::min(
                                nearest, glm::distance(a + t * along, glm::dvec2(column, row)));
                        }
                    }
                    if (nearest < 0.001)
                        continue; // rounded to either side
                    QCOMPARE(voxels.count({row, column}) != 0, around % 2 != 0);
                    ++compared;
                }
            }
        }
        QVERIFY(compared > 50000);
    }

    /// Edges through centres: two boxes that share an edge share no voxel and leave none out.
    void edgesThroughCentres()
    {
        const SlicePolygon left = polygonOf({{2, 1}, {5, 1}, {5, 4}, {2, 4}});
        const SlicePolygon right = polygonOf({{5, 1}, {9, 1}, {9, 4}, {5, 4}});
        const std::set<Voxel> one = filled({left}, {12, 8});
        const std::set<Voxel> other = filled({right}, {12, 8});
        QCOMPARE(one.size(), std::size_t(9));
        QCOMPARE(other.size(), std::size_t(12));
        QVERIFY(one.count({1, 2}) && !one.count({1, 5}) && other.count({1, 5}));
        QVERIFY(!one.count({4, 2}));
        std::set<Voxel> both = one;
        both.insert(other.begin(), other.end());
        QCOMPARE(both.size(), one.size() + other.size());
        QCOMPARE(both, filled({polygonOf({{2, 1}, {9, 1}, {9, 4}, {2, 4}})}, {12, 8}));
    }

    void holesAndKeyholes()
    {
        QTemporaryDir folder;
        const std::vector<glm::dvec2> outer{{1.5, 1.5}, {12.5, 1.5}, {12.5, 10.5}, {1.5, 10.5}};
        const std::vector<glm::dvec2> inner{{4.5, 3.5}, {8.5, 3.5}, {8.5, 7.5}, {4.5, 7.5}};
        std::vector<glm::dvec2> keyhole{{1.5, 1.5}, {12.5, 1.5}, {12.5, 10.5}, {1.5, 10.5},
            {1.5, 3.5}, {4.5, 3.5}, {4.5, 7.5}, {8.5, 7.5}, {8.5, 3.5}, {4.5, 3.5}, {1.5, 3.5}};
        const QString two = folder.filePath(QStringLiteral("two.dcm"));
        write(two,
            {{"Ring \xc3\xa4", {contourData(outer, 103.0), contourData(inner, 103.0)}},
                {"Dot", {contourData({{3, 3}}, 103.0)}, "POINT"}});
        const auto ring = core::readMask(two, boxVolume(), {});
        QVERIFY(ring);
        QCOMPARE(ring->segments.size(), std::size_t(1));
        QCOMPARE(ring->segments.front().name, QString::fromUtf8("Ring \xc3\xa4"));
        QCOMPARE(*ring->segments.front().rgb, 0xff8000U);
        QCOMPARE(ring->notes,
            (std::vector<MaskNote>{
                {.code = MaskNote::Code::NothingSurrounded, .names = {QStringLiteral("Dot")}}}));
        std::set<std::uint64_t> expected;
        for (int row = 2; row <= 10; ++row) {
            for (int column = 2; column <= 12; ++column) {
                if (row < 4 || row > 7 || column < 5 || column > 8)
                    expected.insert(placeAt(column, row, 1));
            }
        }
        QCOMPARE(placesOf(ring->segments.front().voxels), expected);

        const QString one = folder.filePath(QStringLiteral("one.dcm"));
        write(one, {{"Ring", {contourData(keyhole, 103.0)}}});
        const auto keyed = core::readMask(one, boxVolume(), {});
        QVERIFY(keyed);
        QCOMPARE(placesOf(keyed->segments.front().voxels), expected);
    }

    /// Values too long to be read with the header are fetched from the right place of the file.
    void manyPoints()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.dcm"));
        std::vector<glm::dvec2> circle;
        for (int point = 0; point < 2000; ++point) {
            const double angle = point * std::acos(-1.0) / 1000.0;
            circle.emplace_back(9.3 + 6.1 * std::cos(angle), 7.2 + 6.1 * std::sin(angle));
        }
        write(file, {{"Disc", {contourData(circle, 106.0)}}});
        const auto mask = core::readMask(file, boxVolume(), {});
        QVERIFY2(mask, qPrintable(mask ? QString() : mask.error().arguments.join(u' ')));
        std::set<std::uint64_t> expected;
        for (int row = 0; row < 16; ++row) {
            for (int column = 0; column < 20; ++column) {
                if (glm::distance(glm::dvec2(column, row), glm::dvec2(9.3, 7.2)) < 6.1)
                    expected.insert(placeAt(column, row, 2));
            }
        }
        QCOMPARE(placesOf(mask->segments.front().voxels), expected);
    }

    void betweenSlices()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.dcm"));
        const std::vector<glm::dvec2> box{{1.5, 1.5}, {4.5, 1.5}, {4.5, 4.5}, {1.5, 4.5}};
        // Planes 2 mm apart at 101, 103.1 and 105.1; slices at 100, 103, 106, 109, 112.
        write(file,
            {{"Box", {contourData(box, 101.1), contourData(box, 103.1), contourData(box, 105.1)}}});
        const auto mask = core::readMask(file, boxVolume(), {});
        QVERIFY(mask);
        QCOMPARE(mask->notes.size(), std::size_t(1));
        QVERIFY(mask->notes.front().code == MaskNote::Code::BetweenSlices);
        QCOMPARE(mask->notes.front().mm, 1.0);
        std::set<std::uint64_t> slices;
        for (const std::uint64_t place : placesOf(mask->segments.front().voxels))
            slices.insert(place / (20 * 16));
        QCOMPARE(slices, (std::set<std::uint64_t>{1, 2}));
    }

    void roundedCoordinates_data()
    {
        QTest::addColumn<int>("decimals");
        QTest::newRow("two decimals") << 2;
        QTest::newRow("one decimal") << 1;
    }
    /// Each contour of a slice has a height of its own then, by the rounding of its points.
    void roundedCoordinates()
    {
        QFETCH(int, decimals);
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.dcm"));
        const core::Volume volume = obliqueVolume();
        Drawn organ{.name = "Organ", .contours = {}};
        std::set<std::uint64_t> expected;
        for (int k = 0; k < 5; ++k) {
            organ.contours.push_back(roundedData(volume, boxOf(1.5, 1.5, 10.5, 12.5), k, decimals));
            organ.contours.push_back(roundedData(volume, boxOf(3.5, 4.5, 6.5, 7.5), k, decimals));
            organ.contours.push_back(
                roundedData(volume, boxOf(13.5, 2.5, 17.5, 5.5 + k), k, decimals));
            for (int row = 2; row <= 12; ++row) {
                for (int column = 2; column <= 17; ++column) {
                    const bool hole = column > 3 && column < 7 && row > 4 && row < 8;
                    const bool part = column > 13 && row > 2 && row < 6 + k;
                    if ((column < 11 && !hole) || part)
                        expected.insert(placeAt(column, row, k));
                }
            }
        }
        write(file, {organ});
        const auto mask = core::readMask(file, volume, {});
        QVERIFY2(mask, qPrintable(mask ? QString() : mask.error().arguments.join(u' ')));
        QCOMPARE(placesOf(mask->segments.front().voxels), expected);
        QCOMPARE(mask->notes, std::vector<MaskNote>{});
    }

    /// Off the slices, too, the contours of a plane are together.
    void roundedCoordinatesBetweenSlices()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.dcm"));
        const core::Volume volume = obliqueVolume();
        Drawn one{.name = "Ring", .contours = {}};
        Drawn other{.name = "Part", .contours = {}};
        for (int k = 0; k < 4; ++k) {
            one.contours.push_back(roundedData(volume, boxOf(1.5, 1.5, 10.5, 12.5), k + 0.3, 2));
            one.contours.push_back(roundedData(volume, boxOf(3.5, 4.5, 6.5, 7.5), k + 0.3, 2));
            other.contours.push_back(roundedData(volume, boxOf(13.5, 2.5, 17.5, 5.5), k + 0.3, 2));
        }
        write(file, {one, other});
        const auto mask = core::readMask(file, volume, {});
        QVERIFY(mask);
        QCOMPARE(mask->notes.size(), std::size_t(1));
        QVERIFY(mask->notes.front().code == MaskNote::Code::BetweenSlices);
        QVERIFY(std::abs(mask->notes.front().mm - 1.5) < 0.05);
        QCOMPARE(mask->segments.size(), std::size_t(2));
        QCOMPARE(mask->segments[0].voxels.voxelCount(), std::uint64_t(4 * (9 * 11 - 3 * 3)));
        QCOMPARE(mask->segments[1].voxels.voxelCount(), std::uint64_t(4 * 4 * 3));
    }

    /// Planes that really lie closer together than the study's slices.
    void finePlanesStayApart()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.dcm"));
        core::Volume volume = boxVolume();
        volume.geometry.indexToWorld[2].z = 5.0;
        Drawn organ{.name = "Organ", .contours = {}};
        std::set<std::uint64_t> expected;
        for (int plane = 0; plane <= 66; ++plane)
            organ.contours.push_back(
                roundedData(volume, boxOf(1.5, 1.5, 4.5 + plane % 3, 5.5), 0.06 * plane, 2));
        // Slices at 0, 5, 10, 15 and 20 mm: the planes at 0, 5.1, 9.9, 15 and 19.8 mm, of which the
        // last is too far away.
        const int planes[] = {0, 17, 33, 50};
        for (int k = 0; k < 4; ++k) {
            for (int row = 2; row <= 5; ++row) {
                for (int column = 2; column <= 4 + planes[k] % 3; ++column)
                    expected.insert(placeAt(column, row, k));
            }
        }
        write(file, {organ});
        const auto mask = core::readMask(file, volume, {});
        QVERIFY(mask);
        QCOMPARE(mask->notes.size(), std::size_t(1));
        QVERIFY(mask->notes.front().code == MaskNote::Code::BetweenSlices);
        QVERIFY(std::abs(mask->notes.front().mm - 0.15) < 1e-6);
        QCOMPARE(placesOf(mask->segments.front().voxels), expected);
    }

    void outsideTheStudyIsCounted_data()
    {
        QTest::addColumn<double>("k"); // the slice of a contour of 4 × 3 voxels
        QTest::addColumn<double>("left");
        QTest::addColumn<double>("top");
        QTest::addColumn<int>("outside");
        QTest::newRow("inside") << 2.0 << -0.5 << -0.5 << 0;
        QTest::newRow("up to the last voxel") << 4.0 << 15.5 << 12.5 << 0;
        QTest::newRow("two columns before the first") << 0.0 << -2.5 << 3.5 << 6;
        QTest::newRow("a row behind the last") << 1.0 << 3.5 << 13.5 << 4;
        QTest::newRow("beside the slice") << 1.0 << 40.5 << -300.5 << 12;
        QTest::newRow("a slice before the first") << -1.0 << 3.5 << 3.5 << 12;
        QTest::newRow("far behind the last") << 90.0 << 3.5 << 3.5 << 12;
    }
    void outsideTheStudyIsCounted()
    {
        QFETCH(double, k);
        QFETCH(double, left);
        QFETCH(double, top);
        QFETCH(int, outside);
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.dcm"));
        const core::Volume volume = boxVolume();
        const std::string inner = roundedData(volume, boxOf(3.5, 3.5, 6.5, 5.5), 3.0, 3);
        const std::string other = roundedData(volume, boxOf(left, top, left + 4, top + 3), k, 3);
        write(file, {{"Organ", {inner, other}}});
        const auto mask = core::readMask(file, volume, {});
        QVERIFY(mask);
        QCOMPARE(mask->segments.front().voxels.voxelCount(), std::uint64_t(6 + 12 - outside));
        std::vector<MaskNote> notes;
        if (outside != 0)
            notes.push_back(
                {.code = MaskNote::Code::OutsideStudy, .some = std::uint64_t(outside), .all = 18});
        QCOMPARE(mask->notes, notes);
    }

    /// Planes off the slices, 2 mm apart where these are 3 mm apart: the last ones begin 0.1 mm and
    /// 2.1 mm beyond what is the last slice's.
    void outsideBetweenSlices()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.dcm"));
        Drawn organ{.name = "Organ", .contours = {}};
        for (int plane = 0; plane < 5; ++plane)
            organ.contours.push_back(contourData(boxOf(3.5, 3.5, 6.5, 5.5), 108.6 + 2.0 * plane));
        write(file, {organ});
        const auto mask = core::readMask(file, boxVolume(), {});
        QVERIFY(mask);
        QCOMPARE(mask->notes.size(), std::size_t(2));
        QVERIFY(mask->notes[0].code == MaskNote::Code::BetweenSlices);
        QCOMPARE(
            mask->notes[1], (MaskNote{.code = MaskNote::Code::OutsideStudy, .some = 8, .all = 20}));
    }

    void refusals()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.dcm"));
        const auto why = [&](const std::vector<Drawn>& rois) {
            write(file, rois);
            const auto mask = core::readMask(file, boxVolume(), {});
            return mask ? QString() : mask.error().arguments.value(1);
        };
        QCOMPARE(why({}), QStringLiteral("it has no closed contour"));
        QCOMPARE(why({{"A", {"1\\2\\3\\4"}}}),
            QStringLiteral("a contour of 'A' has numbers that are no points"));
        QCOMPARE(why({{"A", {"0\\6\\103\\4\\6\\103\\4\\9\\107"}}}),
            QStringLiteral("contours of 'A' do not lie along the study's slices"));
        QCOMPARE(why({{"A", {contourData({{1, 1}, {5, 1}, {5, 5}}, 400.0)}}}),
            QStringLiteral("it lies wholly outside the study"));
    }

    /// The contours of the IBSI phantom against the mask that comes with them.
    void againstAMaskByAnotherProgram()
    {
        const test::SharedCase shared = test::sharedCase(QStringLiteral("ct_ibsi_lung_rtstruct"));
        if (shared.source.isEmpty())
            QSKIP("no shared test data");
        const QString images = QDir(shared.unpacked).filePath(QStringLiteral("dicom"));
        const auto loaded = core::loadVolume(images);
        QVERIFY(loaded);
        const auto contours =
            core::readMask(images + QStringLiteral("/mask/DCM_RS_00060.dcm"), loaded->volume, {});
        QVERIFY2(
            contours, qPrintable(contours ? QString() : contours.error().arguments.join(u' ')));
        const auto labels =
            core::readMask(shared.source + QStringLiteral("/mask.nii.gz"), loaded->volume, {});
        QVERIFY(labels);
        QVERIFY(contours->notes.empty());
        QCOMPARE(contours->segments.front().name, QStringLiteral("GTV-1"));
        const core::VoxelRuns& ours = contours->segments.front().voxels;
        const core::VoxelRuns& theirs = labels->segments.front().voxels;
        const double dice = 2.0 * double(core::sharedVoxels(ours, theirs))
            / double(ours.voxelCount() + theirs.voxelCount());
        qInfo("Dice %.6f, %llu voxels here, %llu there", dice,
            static_cast<unsigned long long>(ours.voxelCount()),
            static_cast<unsigned long long>(theirs.voxelCount()));
        QVERIFY(dice > 0.99);
    }
};

BURIN_TEST(ContourMaskTest)

} // namespace contourMaskTest

#include "ContourMaskTest.moc"
