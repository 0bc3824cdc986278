// The histogram of depths. A bar that is pressed filters the findings by its range, pressed again by none.

function barChart(counts, rangeOf, choose) {
  const width = 300, height = 118, base = height - 16, top = 14;
  const most = Math.max(1, ...counts);
  const chart = drawing("svg", {viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": "Histogram"});
  const step = width / counts.length;
  counts.forEach((count, i) => {
    // Rare depths are those that matter: a bar that stands for anything can be seen.
    const tall = count === 0 ? 0 : Math.max(3, ((base - top) * count) / most);
    const {from, to, words} = rangeOf(i);
    const bar = drawing("rect", {x: i * step + 0.5, y: base - tall, width: step - 1, height: tall});
    const said = `${words}: ${counted(count, "record")}`;
    bar.append(drawing("title", {}, said));
    if (count > 0) {
      for (const [name, value] of Object.entries({tabindex: 0, role: "button", "aria-label": said}))
        bar.setAttribute(name, value);
      onPress(bar, () => {
        const chosen = bar.classList.contains("chosen");
        for (const other of document.querySelectorAll("#histogram .chosen")) other.classList.remove("chosen");
        bar.classList.toggle("chosen", !chosen);
        choose(chosen ? null : {from, to});
      });
    }
    chart.append(bar);
  });
  chart.append(drawing("text", {x: 0, y: 10}, `at most ${counted(most, "record")} in a bar`));
  chart.append(drawing("text", {x: 0, y: height - 3}, "0"));
  chart.append(drawing("text", {x: width, y: height - 3, "text-anchor": "end"}, rangeOf(counts.length - 1).end));
  return chart;
}

function showHistogram(data, choose) {
  const {deepest, depths, ratios} = data.histogram;
  const place = byId("histogram");
  if (!(deepest > 0)) {
    place.append(element("p", {class: "note"}, "No depths are known."));
    return;
  }
  const depthRange = (i) => {
    const from = (deepest * i) / depths.length, last = i + 1 === depths.length;
    const to = last ? Infinity : (deepest * (i + 1)) / depths.length;
    return {from, to, words: `depth ${short(from)} to ${short(last ? deepest : to)}`, end: short(deepest)};
  };
  const bins = ratios.length - 1;
  const ratioWords = (i) =>
      (i === bins ? "beyond the contact distance" : `${(100 * i) / bins} to ${(100 * (i + 1)) / bins} %`);
  const byRatio = element("details", {}, element("summary", {}, "By share of the distance"));
  const ratioRange = (i) =>
      ({words: ratioWords(i), ratio: true, from: i / bins, to: i === bins ? Infinity : (i + 1) / bins, end: "> 100 %"});
  byRatio.append(barChart(ratios, ratioRange, (range) => choose(range && {...range, ratio: true})));
  place.append(barChart(depths, depthRange, choose), byRatio);
}
