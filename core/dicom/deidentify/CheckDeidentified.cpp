// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/deidentify/Deidentifier.h"

#include "core/dicom/base/DicomFile.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

namespace {

/// Numbers may hold any digits by chance.
bool isText(DcmEVR vr)
{
    switch (vr) {
    case EVR_AE:
    case EVR_CS:
    case EVR_LO:
    case EVR_LT:
    case EVR_PN:
    case EVR_SH:
    case EVR_ST:
    case EVR_UC:
    case EVR_UI:
    case EVR_UR:
    case EVR_UT:
        return true;
    default:
        return false;
    }
}

class Search {
public:
    explicit Search(const QStringList& words)
        : m_words(words)
    {
    }

    /// @return what must not be there; empty if nothing is
    Clause in(DcmItem& item)
    {
        for (unsigned long i = 0; i < item.card(); ++i) {
            DcmElement& element = *item.getElement(i);
            const DcmTag& tag = element.getTag();
            const QString name = QStringLiteral("(%1,%2)")
                                     .arg(tag.getGroup(), 4, 16, QLatin1Char('0'))
                                     .arg(tag.getElement(), 4, 16, QLatin1Char('0'));
            if (tag.getGroup() % 2 != 0)
                return Clause::saying("the private attribute %1 is there", name);
            if (auto* sequence = dynamic_cast<DcmSequenceOfItems*>(&element)) {
                for (unsigned long k = 0; k < sequence->card(); ++k) {
                    if (const Clause what = in(*sequence->getItem(k)); !what.isEmpty())
                        return what;
                }
            } else if (isText(element.ident()) && !isKeyword(element) && identifies(element)) {
                return Clause::saying("attribute %1 tells who the patient is", name);
            }
        }
        return {};
    }
    [[nodiscard]] int looked() const { return m_looked; }

private:
    /// An attribute's own name, which is the standard's: "ImagePositionPatient" of a patient whose
    /// name is Patient.
    static bool isKeyword(DcmElement& element)
    {
        OFString value;
        element.getOFStringArray(value);
        DcmTag attribute;
        return element.getTag() == DCM_DimensionDescriptionLabel
            && DcmTag::findTagFromName(value.c_str(), attribute).good();
    }

    bool identifies(DcmElement& element)
    {
        ++m_looked;
        OFString value;
        element.getOFStringArray(value);
        const QString text = QString::fromUtf8(value.c_str(), qsizetype(value.size()));
        if (text.isEmpty())
            return false;
        const bool uids = element.ident() == EVR_UI;
        for (const QString& word : m_words) {
            const bool isUid = word.contains(QLatin1Char('.')) && word.size() > 12;
            if (uids && isUid && text.split(QLatin1Char('\\')).contains(word))
                return true;
            // A short word may be part of any other; UIDs are digits of which chance holds many.
            if (!uids && isSoughtWithinWords(word) && text.contains(word, Qt::CaseInsensitive))
                return true;
        }
        return false;
    }

    const QStringList& m_words;
    int m_looked = 0;
};

} // namespace

Result<ReportLine> checkDeidentified(const QString& file, const Deidentifier& by)
{
    DcmDataset set;
    if (const Result<void> header = DicomFile::readHeader(file, set); !header)
        return tl::unexpected<Error>(header.error());
    OFString removed;
    OFString patient;
    set.findAndGetOFString(DCM_PatientIdentityRemoved, removed);
    set.findAndGetOFString(DCM_PatientID, patient);
    if (removed != "YES" || QString::fromUtf8(patient.c_str()) != by.patientId())
        return failure(ErrorCode::ExportMismatch, file,
            Clause::saying("it does not say that the patient was taken out of it"));
    Search search(by.words());
    if (const Clause what = search.in(set); !what.isEmpty())
        return failure(ErrorCode::ExportMismatch, file, what);
    return ReportSentence{ReportCode::TextsAreAnonymous, {std::int64_t(search.looked())}};
}

} // namespace core
