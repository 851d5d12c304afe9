// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/retrieve/StorageContexts.h"

namespace core {

namespace {

constexpr std::size_t mostContexts = 128; // PS3.8: odd numbers up to 255
constexpr std::size_t plainCount = 2; // of readableSyntaxes()

} // namespace

const std::vector<QByteArray>& storageClasses()
{
    static const std::vector<QByteArray> classes{
        "1.2.840.10008.5.1.4.1.1.2", // CT
        "1.2.840.10008.5.1.4.1.1.2.1", // enhanced CT
        "1.2.840.10008.5.1.4.1.1.2.2", // legacy converted enhanced CT
        "1.2.840.10008.5.1.4.1.1.4", // MR
        "1.2.840.10008.5.1.4.1.1.4.1", // enhanced MR
        "1.2.840.10008.5.1.4.1.1.4.3", // enhanced MR colour
        "1.2.840.10008.5.1.4.1.1.4.4", // legacy converted enhanced MR
        "1.2.840.10008.5.1.4.1.1.128", // PET
        "1.2.840.10008.5.1.4.1.1.128.1", // legacy converted enhanced PET
        "1.2.840.10008.5.1.4.1.1.130", // enhanced PET
        "1.2.840.10008.5.1.4.1.1.20", // nuclear medicine
        "1.2.840.10008.5.1.4.1.1.7", // secondary capture
        "1.2.840.10008.5.1.4.1.1.7.1", // multi-frame secondary capture, 1 bit
        "1.2.840.10008.5.1.4.1.1.7.2", // … grey, 8 bit
        "1.2.840.10008.5.1.4.1.1.7.3", // … grey, 16 bit
        "1.2.840.10008.5.1.4.1.1.7.4", // … colour
        "1.2.840.10008.5.1.4.1.1.66.4", // segmentation
        "1.2.840.10008.5.1.4.1.1.66.7", // label map segmentation
        "1.2.840.10008.5.1.4.1.1.66.1", // spatial registration
        "1.2.840.10008.5.1.4.1.1.67", // real world value mapping
        "1.2.840.10008.5.1.4.1.1.481.2", // RT dose
        "1.2.840.10008.5.1.4.1.1.481.3", // RT structure set
        "1.2.840.10008.5.1.4.1.1.12.1", // X-ray angiography
        "1.2.840.10008.5.1.4.1.1.13.1.1", // X-ray 3D angiography
        "1.2.840.10008.5.1.4.1.1.13.1.3", // breast tomosynthesis
        "1.2.840.10008.5.1.4.1.1.1", // computed radiography
        "1.2.840.10008.5.1.4.1.1.1.1", // digital X-ray
        "1.2.840.10008.5.1.4.1.1.6.1", // ultrasound
        "1.2.840.10008.5.1.4.1.1.6.2", // enhanced ultrasound volume
        "1.2.840.10008.5.1.4.1.1.11.1", // presentation state
        "1.2.840.10008.5.1.4.1.1.88.11", // basic text report
        "1.2.840.10008.5.1.4.1.1.88.22", // enhanced report
        "1.2.840.10008.5.1.4.1.1.88.33", // comprehensive report
        "1.2.840.10008.5.1.4.1.1.88.34", // comprehensive 3D report
        "1.2.840.10008.5.1.4.1.1.88.59", // key object selection
        "1.2.840.10008.5.1.4.1.1.88.67", // X-ray radiation dose report
        "1.2.840.10008.5.1.4.1.1.88.40", // procedure log
        "1.2.840.10008.5.1.4.1.1.481.5", // RT plan
        "1.2.840.10008.5.1.4.1.1.104.1", // PDF
        "1.2.840.10008.5.1.4.1.1.66", // raw data
        "1.2.840.10008.5.1.4.1.1.1.2", // digital mammography
        "1.2.840.10008.5.1.4.1.1.3.1", // multi-frame ultrasound
        "1.2.840.10008.5.1.4.1.1.11.2", // colour presentation state
    };
    return classes;
}

bool mayBeStorage(const QByteArray& classUid)
{
    return classUid.startsWith("1.2.840.10008.5.1.4.1.1.")
        || classUid == "1.2.840.10008.5.1.4.34.7" // RT beams delivery instruction
        || classUid == "1.2.840.10008.5.1.4.34.10" // RT brachy application setup
        || !classUid.startsWith("1.2.840.10008.");
}

const std::vector<QByteArray>& readableSyntaxes()
{
    static const std::vector<QByteArray> syntaxes{
        "1.2.840.10008.1.2.1", // explicit little endian
        "1.2.840.10008.1.2", // implicit little endian
        "1.2.840.10008.1.2.4.70", // JPEG lossless
        "1.2.840.10008.1.2.4.57",
        "1.2.840.10008.1.2.4.80", // JPEG-LS
        "1.2.840.10008.1.2.4.90", // JPEG 2000 lossless
        "1.2.840.10008.1.2.5", // RLE
        "1.2.840.10008.1.2.4.201", // HTJ2K lossless
        "1.2.840.10008.1.2.4.202",
        "1.2.840.10008.1.2.4.50", // JPEG
        "1.2.840.10008.1.2.4.51",
        "1.2.840.10008.1.2.4.81", // JPEG-LS near-lossless
        "1.2.840.10008.1.2.4.91", // JPEG 2000
        "1.2.840.10008.1.2.4.203", // HTJ2K
        "1.2.840.10008.1.2.1.99", // deflated
        "1.2.840.10008.1.2.2", // explicit big endian
    };
    return syntaxes;
}

std::vector<ProposedContext> retrieveContexts(std::vector<QByteArray> classes)
{
    if (classes.empty())
        classes = storageClasses();
    const std::vector<QByteArray>& all = readableSyntaxes();
    const std::vector<QByteArray> plain(all.begin(), all.begin() + plainCount);
    const std::vector<QByteArray> packed(all.begin() + plainCount, all.end());
    const std::size_t room = mostContexts - 1; // one is the service's
    const bool oneEach = classes.size() * (packed.size() + 1) <= room;
    std::vector<ProposedContext> contexts;
    for (const QByteArray& kind : classes) {
        contexts.push_back({kind, plain, true});
        if (!oneEach) {
            contexts.push_back({kind, packed, true});
            continue;
        }
        for (const QByteArray& syntax : packed)
            contexts.push_back({kind, {syntax}, true});
    }
    if (contexts.size() > room)
        contexts.resize(room);
    return contexts;
}

} // namespace core
