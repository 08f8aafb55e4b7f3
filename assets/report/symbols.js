// What quantities are called in short.

// Short names, for the heads of tables and what the pointer rests on.
export const symbols = {
  mu_v: "μᵥ",
  mu_v_flat: "μᵥ of the flat",
  mu_h: "μₕ",
  mu_tot: "μₜₒₜ",
  mu_drag: "μ_drag",
  mu_pressure: "μ_pressure",
  mu_shear: "μ_shear",
  c: "c",
  film_min: "uₘᵢₙ",
  p_max: "pₘₐₓ",
  x_outlet: "xₒᵤₜ",
};
