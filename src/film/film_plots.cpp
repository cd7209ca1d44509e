// SPDX-License-Identifier: MIT
#include "film/film_plots.h"

#include "motion/recorded.h"

namespace polhode {
namespace {

// more than two for each column of pixels that axes have in a large picture
constexpr int kSteps = 2400;

FilmPlot plot_of(const Recorded& quantity, const Motion& motion) {
  FilmPlot plot;
  plot.title = quantity.title;
  plot.unit = quantity.unit;
  for (const std::string& name : quantity.curves)
    plot.curves.push_back({name, {}});
  plot.begins = 0.0;
  plot.ends = motion.duration();
  plot.now = [motion, values = quantity.values](double t) {
    return values(motion, motion.at(t));
  };
  for (int i = 0; i <= kSteps; ++i) {
    const std::vector<double> now = plot.now(plot.ends * i / kSteps);
    for (std::size_t k = 0; k < plot.curves.size(); ++k)
      plot.curves[k].values.push_back(now[k]);
  }
  return plot;
}

}  // namespace

std::vector<FilmPlot> make_plots(const Solved& solved) {
  std::vector<FilmPlot> plots;
  for (const std::string& name : solved.scene.show.plots) {
    for (const Recorded& quantity : recorded_quantities()) {
      if (quantity.name == name) plots.push_back(plot_of(quantity, solved.simulation.motion));
    }
  }
  return plots;
}

}  // namespace polhode
