// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/FuzzTargets.h"

#include "core/dicom/objects/RtStructFile.h"
#include "core/dicom/objects/SegReader.h"
#include "core/masks/MaskOnVolume.h"
#include "core/study/StudyLoader.h"

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
    (void)readMask(path, smallVolume(), Progress());
}

void openVolumeFile(const char* name, FuzzBytes bytes)
{
    const ScratchFile file(name, bytes);
    openStudy(file.path());
    openMask(file.path());
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
