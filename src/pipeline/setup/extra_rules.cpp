// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "model/number_text.h"
#include "model/rules/link_selection.h"
#include "setup_parts.h"

namespace collision_monitor {

void padLinks(const std::vector<NamedPadding>& paddings, const std::string& where,
              const RobotModel& model, std::vector<LinkRules>& rules, SetupReport& report) {
  for (const NamedPadding& padding : paddings) {
    const std::string place = where + "/" + padding.link;
    if (!std::isfinite(padding.padding) || padding.padding < 0.0) {
      report.errors.push_back({place, shortText(padding.padding) + " m", "a finite number >= 0 m"});
    }
    const std::vector<LinkId> links = findMatching(padding.link, model);
    if (links.empty() && !report.awaits_names) {
      report.errors.push_back({place, "link " + quoted(padding.link) + ", which matches none",
                               "links of the robots: " + linkNames(model)});
    }
    for (const LinkId link : links) {
      std::optional<double>& of_link = rules[index(link)].padding;
      of_link = of_link.value_or(padding.padding);
    }
  }
}

void giveSpheres(const std::vector<SrdfPairs>& srdfs, std::vector<LinkRules>& rules) {
  for (const SrdfPairs& srdf : srdfs) {
    for (const SrdfPairs::Spheres& approximation : srdf.spheres) {
      LinkRules& of_link = rules[index(approximation.link)];
      if (!of_link.given) {
        of_link.given = GivenShapes{approximation.spheres, true,
                                    srdf.source + " line " + std::to_string(approximation.line) +
                                        ", link_sphere_approximation"};
      }
    }
  }
}

}  // namespace collision_monitor
