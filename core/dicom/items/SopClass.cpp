// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/items/SopClass.h"

#include "core/dicom/base/DicomFile.h"
#include "core/dicom/items/ItemReader.h"

#include <QLatin1String>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <vector>

namespace core {

namespace {

struct NamedSopClass {
    const char* uid; ///< the class, or the beginning of a family of classes
    Clause name;
};

constexpr const char* parametricMap = "1.2.840.10008.5.1.4.1.1.30";

// PS3.4 annex B.5 and PS3.3 annex F.
const std::vector<NamedSopClass>& namedSopClasses()
{
    static const std::vector<NamedSopClass> all{
        {"1.2.840.10008.1.3.10", Clause::saying("DICOMDIR")},
        {"1.2.840.10008.5.1.4.1.1.66.4", Clause::saying("DICOM SEG")},
        {"1.2.840.10008.5.1.4.1.1.66.7", Clause::saying("DICOM SEG")},
        {"1.2.840.10008.5.1.4.1.1.66.5", Clause::saying("surface segmentation")},
        {"1.2.840.10008.5.1.4.1.1.66", Clause::saying("registration")},
        {"1.2.840.10008.5.1.4.1.1.67", Clause::saying("real world value mapping")},
        {"1.2.840.10008.5.1.4.1.1.481.3", Clause::saying("RT structure set")},
        {"1.2.840.10008.5.1.4.1.1.481.5", Clause::saying("RT plan")},
        {"1.2.840.10008.5.1.4.1.1.481.8", Clause::saying("RT plan")},
        {"1.2.840.10008.5.1.4.1.1.88", Clause::saying("structured report")},
        {"1.2.840.10008.5.1.4.1.1.11", Clause::saying("presentation state")},
        {"1.2.840.10008.5.1.4.1.1.104", Clause::saying("encapsulated document")},
        {parametricMap, Clause::saying("parametric map of whole numbers")},
        {"1.2.840.10008.5.1.4.1.1.9", Clause::saying("waveform")},
    };
    return all;
}

} // namespace

Clause kindWithoutSlices(const ImageHeader& header)
{
    for (const NamedSopClass& kind : namedSopClasses()) {
        const QLatin1String uid(kind.uid);
        if (header.sopClassUid == uid
            || (header.sopClassUid.startsWith(uid)
                && header.sopClassUid.at(uid.size()) == QLatin1Char('.'))) {
            // A map of floating-point numbers is a volume like others.
            if (header.layout.floatBits == 0 || uid != QLatin1String(parametricMap))
                return kind.name;
        }
    }
    if (!header.hasPixels)
        return Clause::saying("object without an image");
    if (header.hasModalityLut && !header.modalityLut)
        return Clause::saying("image with a damaged modality lookup table");
    return {};
}

bool isDose(const QString& sopClassUid)
{
    return sopClassUid == QLatin1String(UID_RTDoseStorage);
}

bool haveFramesInARow(const QString& sopClassUid)
{
    return isDose(sopClassUid) || sopClassUid == QLatin1String(UID_NuclearMedicineImageStorage);
}

Result<QString> sopClassOf(const QString& path)
{
    const Result<DicomFile> file = DicomFile::open(path);
    if (!file)
        return tl::unexpected<Error>(file.error());
    if (!file->mediaSopClassUid().isEmpty())
        return file->mediaSopClassUid();
    DcmDataset dataset;
    if (const Result<void> parsed = file->readInto(dataset); !parsed)
        return tl::unexpected<Error>(parsed.error());
    return ItemReader(&dataset).text(DCM_SOPClassUID);
}

} // namespace core
