// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/NodeStatus.h"

namespace core {

namespace {

const char* words(std::uint16_t status)
{
    switch (status) {
    case 0x0110:
        return "it failed while it worked on it";
    case 0x0122:
        return "it does not take this kind of object";
    case 0x0124:
        return "it does not allow us to";
    case 0xa801:
        return "it does not know where to send to";
    case 0xfe00:
        return "it was called off there";
    default:
        break;
    }
    switch (status >> 8) {
    case 0xa7:
        return "it is out of resources";
    case 0xa9:
        return "the object is not what it expects";
    case 0xb0:
        return "some of it did not succeed";
    default:
        return (status >> 12) == 0xc ? "it does not understand" : "no reason that DICOM knows";
    }
}

} // namespace

QString statusText(std::uint16_t status)
{
    return QStringLiteral("%1 (0x%2)")
        .arg(QLatin1String(words(status)))
        .arg(uint(status), 4, 16, QLatin1Char('0'));
}

} // namespace core
