#pragma once

// The XML of drone files.

#include "geom/text/xml_element.h"

namespace traj {

using geom::parse_xml;
using geom::XmlElement;

}  // namespace traj
