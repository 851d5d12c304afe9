// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/FuzzTargets.h"

#include "core/chunks/ProbabilityMap.h"
#include "core/dicom/objects/RtStructFile.h"
#include "core/dicom/objects/SegReader.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/masks/ReadImport.h"
#include "core/masks/ReadProbabilities.h"
#include "core/study/StudyLoader.h"

#include <optional>
#include <vector>

namespace test {

using namespace core;

namespace {

void openStudy(const QString& path)
{
    const Result<Study> study = Study::scan(path);
    if (!study)
        return;
    for (const StudyEntry& entry : study->listing().studies) {
        for (const SeriesEntry& series : entry.series)
            (void)study->load(series.key);
    }
}

void openMask(const QString& path)
{
    const Result<ReadImport> read = readImport({.file = path}, smallVolume(), 0, Progress());
    if (read)
        (void)checkOverlaps(*read);
}

void openVolumeFile(const char* name, FuzzBytes bytes)
{
    const ScratchFile file(name, bytes);
    openStudy(file.path());
    openMask(file.path());
}

void openHeader(const char* name, FuzzBytes bytes)
{
    static const std::vector<std::uint8_t> voxels(std::size_t(1) << 16, 1);
    const ScratchFile beside("file.raw", voxels);
    openVolumeFile(name, bytes);
}

} // namespace

void fuzzNifti(FuzzBytes bytes)
{
    openVolumeFile("file.nii", bytes);
}

void fuzzPackedNifti(FuzzBytes bytes)
{
    openVolumeFile("file.nii.gz", bytes);
}

void fuzzNrrd(FuzzBytes bytes)
{
    openVolumeFile("file.nrrd", bytes);
}

void fuzzMetaImage(FuzzBytes bytes)
{
    openVolumeFile("file.mha", bytes);
}

void fuzzNrrdHeader(FuzzBytes bytes)
{
    openHeader("file.nhdr", bytes);
}

void fuzzMetaHeader(FuzzBytes bytes)
{
    openHeader("file.mhd", bytes);
}

void fuzzProbability(FuzzBytes bytes)
{
    const ScratchFile file("file.nii", bytes);
    const Volume volume = smallVolume();
    const auto read = readProbabilities(
        {.segment = 1, .probabilityFile = file.path()}, QStringLiteral("A"), volume, Progress());
    if (!read)
        return;
    // What is read is what an edit can hold.
    const std::optional<QByteArray>& map = read->edit.probabilities;
    if (!map || !ProbabilityMap::unpacked(*map, volume.geometry.voxelCount()))
        qFatal("a map that was read cannot be unpacked");
}

void fuzzImages(FuzzBytes bytes)
{
    // Which of the two it is the bytes say. Pictures open with a spacing only.
    const ScratchFile file("file.tif", bytes);
    (void)loadVolume(file.path(), QStringLiteral("+spacing=1x1x1"));
}

void fuzzDicom(FuzzBytes bytes)
{
    const ScratchFile file("file.dcm", bytes);
    openStudy(file.path());
}

void fuzzSeg(FuzzBytes bytes)
{
    const ScratchFile file("file.dcm", bytes);
    (void)readSeg(file.path());
    openMask(file.path());
}

void fuzzRtStruct(FuzzBytes bytes)
{
    const ScratchFile file("file.dcm", bytes);
    (void)readRtStruct(file.path());
    openMask(file.path());
}

} // namespace test
