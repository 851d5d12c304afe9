// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRunSets.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/masks/MaskOnVolume.h"
#include "core/refine/deform/RefineSurface.h"
#include "core/refine/fit/MeasuredFit.h"
#include "core/refine/mesh/InternalForces.h"
#include "core/refine/tools/SurfaceStroke.h"
#include "core/session/surface/SurfaceWork.h"
#include "core/session/surface/SurfaceWriteBack.h"
#include "core/study/StudyLoader.h"
#include "core/titles/RowTitle.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"

#include <QDir>
#include <QFile>
#include <QTest>

#include <algorithm>

namespace referenceMasksTest {

using namespace core;

namespace {

constexpr std::uint8_t label = 1;
/// Less says nothing.
constexpr std::uint64_t fewestVoxels = 100;
/// More takes too long for every day.
constexpr std::uint64_t mostFaces = 20'000;

std::vector<std::uint8_t> labelsOf(const VoxelRuns& voxels, const glm::ivec3& size)
{
    std::vector<std::uint8_t> labels(
        std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 0);
    for (const VoxelRun& run : voxels.runs())
        std::fill_n(labels.begin() + std::ptrdiff_t(run.first), run.count, label);
    return labels;
}

VoxelRuns changedBy(const RelabelListed& edit, const glm::ivec3& size)
{
    const BrickGrid grid{size};
    std::vector<std::uint64_t> places;
    for (const RelabelListed::Brick& brick : edit.bricks) {
        const VoxelBox box = grid.boxOf(int(brick.brick));
        for (int z = box.minimum.z; z < box.maximum.z; ++z)
            for (int y = box.minimum.y; y < box.maximum.y; ++y)
                for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                    if (brick.asked[std::size_t(BrickGrid::offsetInBrick({x, y, z}))] != 0)
                        places.push_back(
                            (std::uint64_t(z) * std::uint64_t(size.y) + std::uint64_t(y))
                                * std::uint64_t(size.x)
                            + std::uint64_t(x));
                }
    }
    std::sort(places.begin(), places.end());
    VoxelRuns runs;
    for (const std::uint64_t place : places)
        runs.append(place, 1);
    return runs;
}

/// Between the voxels and what is around them.
std::uint64_t facesOf(const VoxelRuns& voxels, const VolumeGeometry& geometry)
{
    const glm::u64vec3 faces = BoxMask::of(voxels, geometry.size).borderFaces();
    return faces.x + faces.y + faces.z;
}

/// Grown by so many voxels along any of the 26 ways.
VoxelRuns grown(VoxelRuns voxels, const glm::ivec3& size, int steps)
{
    for (int step = 0; step < steps; ++step)
        voxels = united(voxels, shellAround(voxels, size));
    return voxels;
}

/// The surface as the program lays it, and what its row says of how much it is off.
struct Laid {
    SurfaceState surface;
    QString told;
};

Laid laid(const std::vector<std::uint8_t>& labels, const VolumeGeometry& geometry, int vertices)
{
    Laid made;
    made.surface.setGeometry(geometry);
    Document document;
    if (!apply(AddSegment{}, document).value_or(false))
        return made;
    SurfaceWork work(
        made.surface, LaySurface{.segment = label, .vertices = vertices}, document, {});
    work.setLabels(labels);
    if (!work.begin())
        return made;
    if (const auto outcome = work.end(Ending::Commit); outcome && outcome->remark)
        made.told = canonicalName(*outcome->remark);
    return made;
}

} // namespace

/// Masks that people and networks made: to their surface and back.
class ReferenceMasksTest : public QObject {
    Q_OBJECT

    void untouchedAndPushed(const MaskSegment& segment, const VolumeGeometry& geometry);

private Q_SLOTS:
    void thereAndBack_data();
    void thereAndBack();
};

void ReferenceMasksTest::thereAndBack_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("study"); // empty: the mask is a volume, too, of its labels
    for (const auto& [name, files] :
        std::vector<std::pair<const char*, std::vector<const char*>>>{
            {"ct_totalseg_body_3mm",
                {"ct_3mm_labels.nii.gz", "aorta/aorta.nii.gz", "aorta/vertebrae_T12.nii.gz",
                    "aorta/subclavian_artery_left.nii.gz", "aorta/brachiocephalic_trunk.nii.gz",
                    "aorta/superior_mesenteric_artery.nii.gz", "aorta/celiac_trunk.nii.gz",
                    "aorta/common_carotid_artery_left.nii.gz"}},
            {"ct_abdomen_j2k_organs", {"labels.nii.gz"}},
            {"ct_cranium_inv3",
                {"mask_bone_226_3071.nii.gz", "mask_soft_and_bone_minus142_2986.nii.gz"}},
            {"ct_ibsi_lung_rtstruct", {"mask.nii.gz"}},
            {"ct_mr_pet_sts001", {"CT_mask.nii.gz", "PET_mask.nii.gz", "MR_T1_mask.nii.gz"}},
            {"mr_brain_ch2_atlases", {"aal.nii.gz", "brodmann.nii.gz"}},
            {"mr_brain_mricrop_itksnap", {"labels.nii.gz"}},
            {"mr_brain_tumour_nrrd",
                {"brain1_label.nrrd", "prostate_phantom_subvolume-label.nrrd"}},
            {"mr_spine_t2_cord",
                {"t2_seg-manual.nii.gz", "t2_seg-deepseg_rootlets-manual.nii.gz", "labels.nii.gz"}},
            {"seg_dcmqi_liver",
                {"nrrd/liver_seg.nrrd", "nrrd/spine_seg.nrrd", "nrrd/heart_seg.nrrd",
                    "nrrd/spine_seg_label5.nrrd", "nrrd/liver_spine_seg.nrrd",
                    "nrrd/liver_spine_gapped_seg.nrrd"}}}) {
        for (const char* file : files)
            QTest::addRow("%s/%s", name, file)
                << QString::fromLatin1(name) << QString::fromLatin1(file) << QString();
    }
    // As a scanner's workstation wrote it, of 212 voxels; its other segment has but 54.
    QTest::addRow("pet_headneck_seg")
        << QStringLiteral("pet_headneck_seg")
        << QStringLiteral("dicom/SEG/tumor_User1_Manual_Trial1.dcm") << QStringLiteral("dicom");
    if (!test::longRun())
        return;
    // Bodies of a single slice.
    for (const auto& [name, file] : {std::pair{"seg_dcmqi_liver", "nrrd/partial_overlaps-1.nrrd"},
             std::pair{"seg_dcmqi_liver", "nrrd/partial_overlaps-2.nrrd"},
             std::pair{"seg_dcmqi_liver", "nrrd/partial_overlaps-3.nrrd"},
             std::pair{"edge_multiframe", "dcmqi_24x38x3_label.nrrd"}})
        QTest::addRow("%s/%s", name, file)
            << QString::fromLatin1(name) << QString::fromLatin1(file) << QString();
}

/// The largest segment of each that is not too large; with BURIN_LONG=1 all that there are.
void ReferenceMasksTest::thereAndBack()
{
    QFETCH(QString, name);
    QFETCH(QString, file);
    QFETCH(QString, study);
    const test::SharedCase shared = test::sharedCase(name);
    if (shared.source.isEmpty())
        QSKIP("no shared test data");
    const QDir folder(study.isEmpty() ? shared.source : shared.unpacked);
    const QString path = folder.filePath(file);
    if (!QFile::exists(path))
        QSKIP(qPrintable(QStringLiteral("%1 is missing").arg(path)));
    const auto loaded = loadVolume(study.isEmpty() ? path : folder.filePath(study), {});
    QVERIFY(loaded.has_value());
    const VolumeGeometry& geometry = loaded->volume.geometry;
    auto mask = readMask(path, loaded->volume, {});
    QVERIFY(mask.has_value());
    std::erase_if(mask->segments, [&geometry](const MaskSegment& segment) {
        const std::uint64_t voxels = segment.voxels.voxelCount();
        const std::uint64_t faces = facesOf(segment.voxels, geometry);
        const bool leftOut = voxels < fewestVoxels || (!test::longRun() && faces > mostFaces);
        if (leftOut)
            qInfo("%s is left out: %llu voxels, %llu faces", qPrintable(segment.name),
                static_cast<unsigned long long>(voxels), static_cast<unsigned long long>(faces));
        return leftOut;
    });
    if (mask->segments.empty())
        QSKIP(test::longRun() ? "all of it is too small" : "none of a size for every day");
    std::stable_sort(mask->segments.begin(), mask->segments.end(),
        [](const auto& a, const auto& b) { return a.voxels.voxelCount() > b.voxels.voxelCount(); });
    if (!test::longRun())
        mask->segments.resize(1);
    for (const MaskSegment& segment : mask->segments) {
        untouchedAndPushed(segment, geometry);
        if (QTest::currentTestFailed())
            return;
    }
}

void ReferenceMasksTest::untouchedAndPushed(
    const MaskSegment& segment, const VolumeGeometry& geometry)
{
    const glm::ivec3& size = geometry.size;
    const std::vector<std::uint8_t> labels = labelsOf(segment.voxels, size);
    const LabelTarget target{.plane = 0, .label = label};
    // So few that what is enclosed is another.
    const std::optional<int> vertices = test::longRun() ? std::nullopt : std::optional(3000);
    auto fit = measuredFit(segment.voxels, geometry, vertices, {});
    QVERIFY(fit.has_value());
    SimplexMesh& mesh = fit->mesh;
    const auto untouched = enclosedVoxels(mesh, {}, geometry, false);
    QVERIFY(untouched.has_value());
    const std::uint64_t off = differing(untouched->now, segment.voxels).voxelCount();
    QCOMPARE(off, fit->voxelsOff);
    // What is off by more than a thousandth is told in the row that lays it, as it is measured
    // here.
    const double share = double(off) / double(segment.voxels.voxelCount());
    if (share > mostOffShare) {
        const Laid told = laid(labels, geometry, vertices.value_or(0));
        QVERIFY(identical(told.surface.mesh, mesh));
        QCOMPARE(told.told, QStringLiteral("%1 % off").arg(100.0 * share, 0, 'f', 2));
    }
    // Two vertices for each face nearly suffice, unless they are more than a surface may have.
    constexpr double mostToldShare = 0.01;
    const std::uint64_t wanted = 2 * facesOf(segment.voxels, geometry);
    if (test::longRun())
        QVERIFY2(share <= mostToldShare || wanted > std::uint64_t(mostVerticesOnce),
            qPrintable(QStringLiteral("%1: %2 % off").arg(segment.name).arg(100.0 * share)));
    QVERIFY(writeBackOf(*untouched, labels, size, target).bricks.empty());

    // A ball pushes it out by half a radius, somewhere where the body is thick enough for that.
    const glm::dvec3 spacing = geometry.spacingMm();
    const double radiusMm = 6.0 * std::min({spacing.x, spacing.y, spacing.z});
    const BoundaryForce boundary(BoxMask::of(segment.voxels, size), geometry, 4.0);
    glm::dvec3 centre(0.0);
    Result<EnclosedVoxels> pushed = *untouched;
    const std::size_t places = test::longRun() ? 512 : 16;
    VoxelRuns moved;
    for (VertexId id = 0; id < mesh.vertexSlots() && moved.empty();
         id += VertexId(std::max<std::size_t>(mesh.vertexSlots() / places, 1))) {
        if (!mesh.hasVertex(id))
            continue;
        centre = mesh.position(id) - 0.5 * radiusMm * frameAt(mesh, id).normalLps;
        auto step = std::make_shared<SurfaceStep>();
        SurfaceStroke stroke(mesh, &boundary, SphereTool{.radiusMm = radiusMm}, {.reddens = true});
        stroke.add({.placeLps = centre});
        step->mesh = stroke.commit();
        pushed = enclosedVoxels(
            mesh, {.rows = {{.what = SurfacePast::What::Deformed, .step = step}}}, geometry, false);
        QVERIFY(pushed.has_value());
        moved = differing(pushed->now, pushed->agreed);
    }
    QVERIFY(!moved.empty());
    const VoxelRuns changed = changedBy(writeBackOf(*pushed, labels, size, target), size);
    const VoxelRuns written = differing(segment.voxels, changed);
    // Where it was moved over the mask is as the surface; all that changed lies there or beside.
    QCOMPARE(common(written, moved), common(pushed->now, moved));
    QCOMPARE(common(changed, grown(moved, size, writeBackRimVoxels)), changed);
    double farthestMm = 0.0;
    for (const VoxelRun& run : changed.runs()) {
        for (std::uint64_t at = run.first; at < run.first + run.count; ++at) {
            const glm::ivec3 voxel(int(at % std::uint64_t(size.x)),
                int(at / std::uint64_t(size.x) % std::uint64_t(size.y)),
                int(at / std::uint64_t(size.x) / std::uint64_t(size.y)));
            farthestMm = std::max(
                farthestMm, glm::distance(geometry.toWorld(glm::dvec3(voxel)), centre) - radiusMm);
        }
    }
    qInfo(
        "%s: %zu vertices, %llu of %llu voxels off; pushed over %llu, %llu changed, up to %.1f mm "
        "around the ball of %.1f mm; %llu followed",
        qPrintable(segment.name), mesh.vertexCount(),
        static_cast<unsigned long long>(fit->voxelsOff),
        static_cast<unsigned long long>(fit->voxels),
        static_cast<unsigned long long>(moved.voxelCount()),
        static_cast<unsigned long long>(changed.voxelCount()), farthestMm, radiusMm,
        static_cast<unsigned long long>(differing(pushed->agreed, untouched->now).voxelCount()));
    // Also where so few vertices leave much to the yellow parts, which follow the mask meanwhile.
    QVERIFY(farthestMm < 2.0 * radiusMm);
}

BURIN_TEST(ReferenceMasksTest)

} // namespace referenceMasksTest

#include "ReferenceMasksTest.moc"
