// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/SecondaryCapture.h"

#include "core/dicom/base/Dcmtk.h"
#include "core/dicom/base/DicomFile.h"
#include "core/dicom/base/NewUid.h"
#include "core/dicom/source/ItemWriter.h"
#include "core/dicom/source/PatientAndPlane.h"
#include "core/dicom/write/MadeObject.h"
#include "core/dicom/write/SaveDicom.h"

#include <QFileInfo>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

namespace {

constexpr int samples = 3;

void describe(DcmDataset& set, const SecondaryCaptureContent& content, const ItemWriter& items)
{
    describeMadeContent(&set,
        madeOf(content.identity, UID_SecondaryCaptureImageStorage, "OT", 5000,
            QStringLiteral("Screenshot")),
        items);
    items.put(&set, DCM_ConversionType, "WSD");
    items.put(&set, DCM_ImageType, "DERIVED\\SECONDARY");
    items.put(&set, DCM_Laterality, "");
    items.put(&set, DCM_PatientOrientation, "");
    items.put(&set, DCM_BurnedInAnnotation, content.picture.showsPatient ? "YES" : "NO");
}

} // namespace

Result<ReportLines> writeSecondaryCapture(
    const QString& path, const SecondaryCaptureContent& content, const Progress& progress)
{
    readyDcmtk();
    const ScreenPicture& picture = content.picture;
    if (picture.width < 1 || picture.height < 1 || picture.width > 65535 || picture.height > 65535
        || picture.rgb.size() != std::size_t(picture.width) * std::size_t(picture.height) * samples)
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("DICOM holds pictures of 1 to 65535 rows and columns"));
    // One image of the study knows all that a picture takes over.
    const std::vector<SourceSlice> first(
        content.sources.begin(), content.sources.begin() + (content.sources.empty() ? 0 : 1));
    if (first.empty())
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("the study was not read from DICOM images, whose patient and study a "
                           "Secondary Capture must name"));
    const auto source = readSegSource(first, content.keptHeaders.get(), progress);
    if (!source)
        return tl::unexpected(source.error());
    DcmFileFormat format;
    DcmDataset& set = *format.getDataset();
    ConditionChain chain;
    const ItemWriter items(chain);
    takePatientAndStudy(set, *source->header, chain);
    set.findAndDeleteElement(DCM_FrameOfReferenceUID);
    describe(set, content, items);
    items.putWord(&set, DCM_SamplesPerPixel, samples);
    items.put(&set, DCM_PhotometricInterpretation, "RGB");
    items.putWord(&set, DCM_PlanarConfiguration, 0);
    items.putWord(&set, DCM_Rows, picture.height);
    items.putWord(&set, DCM_Columns, picture.width);
    items.putWord(&set, DCM_BitsAllocated, 8);
    items.putWord(&set, DCM_BitsStored, 8);
    items.putWord(&set, DCM_HighBit, 7);
    items.putWord(&set, DCM_PixelRepresentation, 0);
    std::vector<std::uint8_t> pixels(picture.rgb.begin(), picture.rgb.end());
    if (pixels.size() % 2 != 0)
        pixels.push_back(0);
    chain(set.putAndInsertUint8Array(
              DCM_PixelData, pixels.data(), static_cast<unsigned long>(pixels.size())),
        "pixels");
    if (!chain.good())
        return failure(ErrorCode::Internal, chain.failure());
    if (const Result<void> saved = saveDicom(format, path, UID_LittleEndianExplicitTransferSyntax);
        !saved)
        return tl::unexpected(saved.error());
    return source->notes;
}

Result<SecondaryCaptureFile> readSecondaryCapture(const QString& path)
{
    if (!QFileInfo::exists(path))
        return failure(ErrorCode::FileNotFound, path);
    const Result<DicomFile> file = DicomFile::openWithPixels(path);
    if (!file)
        return tl::unexpected<Error>(file.error());
    DcmDataset set;
    if (const Result<void> parsed = file->readInto(set); !parsed)
        return tl::unexpected<Error>(parsed.error());
    const ItemReader reader(&set);
    if (reader.text(DCM_SOPClassUID) != QLatin1String(UID_SecondaryCaptureImageStorage)
        || reader.text(DCM_PhotometricInterpretation) != QLatin1String("RGB"))
        return failure(ErrorCode::UnsupportedFormat, path, Clause::saying("no picture in colours"));
    SecondaryCaptureFile read;
    read.patient = readHeaderPatient(set);
    read.studyUid = reader.text(DCM_StudyInstanceUID);
    read.seriesUid = reader.text(DCM_SeriesInstanceUID);
    read.width = reader.integer(DCM_Columns).value_or(0);
    read.height = reader.integer(DCM_Rows).value_or(0);
    const std::size_t needed = std::size_t(read.width) * std::size_t(read.height) * samples;
    const DicomFile::Bytes pixels = file->pixels();
    if (!file->hasPixels() || pixels.size() < needed)
        return failure(ErrorCode::FileTruncated, path, Clause::saying("pixels are missing"));
    read.rgb.assign(pixels.begin(), pixels.begin() + std::ptrdiff_t(needed));
    return read;
}

} // namespace core
