// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/source/SourceHeader.h"
#include "core/titles/ReportSentence.h"
#include "core/volume/Volume.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

class DcmDataset;
class DcmItem;

namespace core {

/// What is kept of the attributes that the Basic Application Level Confidentiality Profile (PS3.15
/// Annex E) removes.
struct DeidentifyOptions {
    enum class Dates {
        Remove,
        Shift, ///< by shiftDays; times of day are kept (113107)
        Keep, ///< 113106
    };
    Dates dates = Dates::Remove;
    int shiftDays = 0;
    bool keepDevice = false; ///< 113109
    /// Descriptions and names of segments, without the words of the patient's identity (113105).
    bool keepDescriptions = false;
};

/// Removes the patient's identity from data sets by one consistent mapping: the same UID is
/// replaced by the same new one everywhere.
///
/// A UID becomes 128 bits of HMAC-SHA256 with a secret; without the secret this can neither be
/// reversed nor repeated. Attributes are kept only if they are known to reveal nothing about the
/// patient (DeidentifiedTags.h). All others are removed, including private ones, overlays and
/// curves. Any thread.
class Deidentifier {
public:
    /// @param secret empty: a random one, so that files written by different objects cannot be
    /// linked
    Deidentifier(
        const DeidentifyOptions& options, const StudyIdentity& patient, QByteArray secret = {});

    [[nodiscard]] const DeidentifyOptions& options() const { return m_options; }
    [[nodiscard]] QString uid(const QString& uid) const;
    [[nodiscard]] QString patientName() const { return QStringLiteral("Anonymous"); }
    [[nodiscard]] QString patientId() const { return m_patientId; }
    /// YYYYMMDD, according to the options; empty if dates are removed.
    [[nodiscard]] QString date(const QString& date) const;
    /// The text without the words of the patient's identity.
    [[nodiscard]] QString cleanText(const QString& text) const;
    /// Words that must not occur in anything written: names, numbers, dates, UIDs.
    [[nodiscard]] const QStringList& words() const { return m_words; }
    /// What was done, in words: "basic profile; dates removed".
    [[nodiscard]] QString method() const;

    /// The name for a segment: the meaning of its code, or "Segment 3"; if names are kept, its own,
    /// cleaned.
    [[nodiscard]] QString segmentName(int label, const QString& name, const QString& meaning) const;
    /// The de-identified form of a header of the source.
    [[nodiscard]] SourceHeader deidentified(SourceHeader header) const;
    [[nodiscard]] StudyIdentity deidentified(StudyIdentity identity) const;

    /// Only for sources of core/dicom. @param settled UIDs that this object has already mapped
    void apply(DcmDataset& set, const QStringList& settled = {}) const;

private:
    struct Pass;
    void applyToItem(DcmItem& item, const Pass& pass) const;

    DeidentifyOptions m_options;
    QByteArray m_secret;
    QString m_patientId;
    QStringList m_words;
};

/// Whether a word of the patient's identity is also searched for inside other words. Short words
/// are not, because ordinary words contain them, except in scripts that write names without spaces
/// around them.
[[nodiscard]] bool isSoughtWithinWords(const QString& word);
/// Whether a text holds that word: anywhere if it is sought within others, else as a whole word.
[[nodiscard]] bool holdsWord(const QString& text, const QString& word);

/// Opens what was written and searches every text and UID in it, including sequences.
/// @returns what was checked, as a sentence
/// Errors: ExportMismatch (argument 1: the attribute with a forbidden word), and those of reading.
[[nodiscard]] Result<ReportLine> checkDeidentified(const QString& file, const Deidentifier& by);

} // namespace core
