// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/source/SourceHeader.h"
#include "core/volume/Volume.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

class DcmDataset;
class DcmItem;

namespace core {

/// What is kept of what PS3.15 Annex E's Basic Application Level Confidentiality Profile takes
/// away.
struct DeidentifyOptions {
    enum class Dates {
        Remove,
        Shift, ///< by shiftDays; times of day stay (113107)
        Keep, ///< 113106
    };
    Dates dates = Dates::Remove;
    int shiftDays = 0;
    bool keepDevice = false; ///< 113109
    /// Descriptions and names of segments, without the words of the patient's identity (113105).
    bool keepDescriptions = false;
};

/// Takes the patient out of data sets, by one mapping: the same UID becomes the same everywhere.
///
/// A UID becomes 128 bits of HMAC-SHA256 under a secret: whoever lacks that can neither undo nor
/// repeat it. Attributes stay only where it is known that they tell nothing of the patient
/// (DeidentifiedTags.h); all others go, private ones, overlays and curves among them. Any thread.
class Deidentifier {
public:
    /// @param secret empty: drawn anew, so that nothing written by another one can be linked
    Deidentifier(
        const DeidentifyOptions& options, const StudyIdentity& patient, QByteArray secret = {});

    [[nodiscard]] const DeidentifyOptions& options() const { return m_options; }
    [[nodiscard]] QString uid(const QString& uid) const;
    [[nodiscard]] QString patientName() const { return QStringLiteral("Anonymous"); }
    [[nodiscard]] QString patientId() const { return m_patientId; }
    /// YYYYMMDD, as the options have it; empty where dates are removed.
    [[nodiscard]] QString date(const QString& date) const;
    /// Without the words of the patient's identity.
    [[nodiscard]] QString cleanText(const QString& text) const;
    /// What must not be found in anything that is written: names, numbers, dates, UIDs.
    [[nodiscard]] const QStringList& words() const { return m_words; }
    /// "basic profile; dates removed": what was done, for a person.
    [[nodiscard]] QString method() const;

    /// A segment's name: its code's meaning, or "Segment 3"; its own, cleaned, where those are
    /// kept.
    [[nodiscard]] QString segmentName(int label, const QString& name, const QString& meaning) const;
    /// What a header of the source says once it is de-identified.
    [[nodiscard]] SourceHeader masked(SourceHeader header) const;
    [[nodiscard]] StudyIdentity masked(StudyIdentity identity) const;

    /// Only for sources of core/dicom. @param settled UIDs that this one has made already
    void apply(DcmDataset& set, const QStringList& settled = {}) const;

private:
    struct Pass;
    void applyToItem(DcmItem& item, const Pass& pass) const;

    DeidentifyOptions m_options;
    QByteArray m_secret;
    QString m_patientId;
    QStringList m_words;
};

/// Opens what was written and looks through every text and UID of it, sequences included.
/// @returns what was checked, as a sentence
/// Errors: ExportMismatch (argument 1: which attribute holds what it must not), and those of
/// reading.
[[nodiscard]] Result<QString> checkDeidentified(const QString& file, const Deidentifier& by);

} // namespace core
