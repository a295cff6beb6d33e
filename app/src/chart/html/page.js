// The wipes: the truth is in the page once, and lies over each method's picture up to the cut.
const truth = document.getElementById("truth");
document.documentElement.style.setProperty("--truth-picture", `url(${truth.src})`);
document.body.classList.add("wipes");
for (const input of document.querySelectorAll(".wipe input")) {
  const cut = () => input.parentElement.style.setProperty("--cut", input.value + "%");
  input.addEventListener("input", cut);
  cut(); // A page that is gone back to keeps its sliders.
}
// The table: a click sorts by a column, another one turns it round; what has no figure comes last.
const number = (cell) => (cell.dataset.value ? Number(cell.dataset.value) : NaN);
for (const button of document.querySelectorAll("thead button")) {
  button.addEventListener("click", () => {
    const head = button.parentElement, column = head.cellIndex, body = head.closest("table").tBodies[0];
    const down = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
    for (const other of head.parentElement.cells) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", down > 0 ? "ascending" : "descending");
    const order = (a, b) => {
      const [x, y] = [a.cells[column], b.cells[column]];
      if (column === 0) return down * x.textContent.localeCompare(y.textContent);
      const [u, v] = [number(x), number(y)];
      return Number.isNaN(u) - Number.isNaN(v) || down * (u - v) || 0;
    };
    body.append(...[...body.rows].sort(order));
  });
}
